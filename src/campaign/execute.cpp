// Works off one job: diagnose, estimate --from-log or replay, and what of it stands in tables.
#include "campaign/execute.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <stdexcept>

#include "command/identify.h"
#include "diagnosis/results/rounding.h"
#include "io/sha256.h"
#include "log/new_file.h"
#include "log/text.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/gap/replay.h"

namespace rubber_suspension::campaign {
namespace {

namespace fs = std::filesystem;

using nlohmann::ordered_json;

constexpr std::size_t kKeptSamples = 4000000;  // of all logs kept: about 100 MB with force and displacement
constexpr std::size_t kKeptConfigs = 16;

// JSON has no infinity; a value that is not finite is left null.
ordered_json number(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr); }

ordered_json ratiosJson(const diagnosis::ParameterRatios& ratios) {
  ordered_json result = ordered_json::object();
  for (const auto& [name, ratio] : ratios) {
    result[name] = number(ratio);
  }
  return result;
}

// "friction | friction + creep": the sets of effects that the logs cannot tell apart.
std::string setsText(const std::vector<std::vector<std::string>>& sets) {
  std::vector<std::string> texts;
  std::transform(sets.begin(), sets.end(), std::back_inserter(texts),
                 [](const std::vector<std::string>& set) { return fmt::format("{}", fmt::join(set, " + ")); });
  return fmt::format("{}", fmt::join(texts, " | "));
}

// What else may be right: sets of effects, and the verdict of what is none.
std::vector<std::vector<std::string>> alternativesOf(const diagnosis::Diagnosis& d) {
  std::vector<std::vector<std::string>> others;
  std::transform(d.alternatives.begin(), d.alternatives.end(), std::back_inserter(others),
                 [](const diagnosis::Alternative& other) {
                   return other.effects.empty() ? std::vector<std::string>{toString(other.verdict)} : other.effects;
                 });
  return others;
}

ordered_json diagnosisValues(const diagnosis::Diagnosis& d) {
  ordered_json values = {{"verdict", toString(d.verdict)},
                         {"effects", log::join(d.effects)},
                         {"confounded", setsText(d.confounded)},
                         {"alternatives", setsText(alternativesOf(d))},
                         {"gap_as_configured", number(d.gap.as_configured)},
                         {"gap_re_estimated", number(d.gap.re_estimated)},
                         {"gap_augmented", number(d.gap.augmented)},
                         {"noise_floor", number(d.gap.noise_floor)},
                         {"closed", number(d.closed)},
                         {"closed_lower", number(d.closed_interval[0])},
                         {"closed_upper", number(d.closed_interval[1])},
                         {"rig_findings", d.rig_findings.size()},
                         {"sentence", d.sentence}};
  for (const auto& [name, ratio] : d.parameter_ratios) {
    values["ratio." + name] = number(ratio);
  }
  return values;
}

// What may be right, first what is said: sets of effects, and one without any where values may be all that is wrong.
ordered_json explanationsJson(const diagnosis::Diagnosis& d) {
  ordered_json list = ordered_json::array();
  const auto add = [&](diagnosis::Verdict verdict, const std::vector<std::string>& effects, double probability) {
    if (!effects.empty() || verdict == diagnosis::Verdict::none || verdict == diagnosis::Verdict::parameter_error) {
      list.push_back({{"effects", effects}, {"probability", number(probability)}});
    }
  };
  add(d.verdict, d.effects, d.probability);
  for (const diagnosis::Alternative& other : d.alternatives) {
    add(other.verdict, other.effects, other.probability);
  }
  return list;
}

ordered_json diagnosisEvidence(const diagnosis::Diagnosis& d) {
  ordered_json by_log = ordered_json::array();
  for (const diagnosis::ParameterByLog& row : d.by_log) {
    by_log.push_back(ratiosJson(row.ratios));
  }
  return {{"verdict", toString(d.verdict)},           {"effects", d.effects},
          {"explanations", explanationsJson(d)},      {"probability_none_of_these", number(d.posterior.none_of_these)},
          {"ratios", ratiosJson(d.parameter_ratios)}, {"ratios_by_log", by_log}};
}

ordered_json replayValues(const log::Log& log, const gap::Replay& replay) {
  double squares = 0.0;
  double work = 0.0;
  for (std::size_t i = 0; i < log.size(); ++i) {
    squares += replay.force[i] * replay.force[i];
    if (i > 0) {
      work += 0.5 * (replay.force[i] + replay.force[i - 1]) * (log.displacement[i] - log.displacement[i - 1]);
    }
  }
  const auto [least, most] = std::minmax_element(replay.force.begin(), replay.force.end());
  ordered_json values = {{"samples", log.size()},
                         {"duration_s", log.time(log.size() - 1) - log.time(0)},
                         {"bridged", replay.bridged},
                         {"force_min_n", *least},
                         {"force_max_n", *most},
                         {"force_rms_n", std::sqrt(squares / static_cast<double>(log.size()))},
                         {"work_j", work}};
  if (!log.force.empty()) {
    values["gap"] = number(gap::relativeGap(log.force, replay.force));
  }
  return values;
}

}  // namespace

Record Executor::execute(const Job& job) {
  const auto start = std::chrono::steady_clock::now();
  Record record;
  record.id = job.id;
  record.version = manifest_.version;
  try {
    work(job, record);
  } catch (const std::exception& error) {
    const std::string reason = log::oneLine(error.what());
    record = {job.id, manifest_.version, reason.empty() ? "failed without a reason" : reason, {}, {}, {}, 0.0};
  }
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  writeRecord(record, folder_);
  return record;
}

void Executor::work(const Job& job, Record& record) {
  switch (job.command) {
    case Command::diagnose:
      diagnose(job, record);
      break;
    case Command::estimate:
      estimate(job, record);
      break;
    case Command::replay:
      replay(job, record);
      break;
  }
  if (job.options.reports != Reports::none) {
    listFiles(job, record);
  }
}

void Executor::diagnose(const Job& job, Record& record) {
  io::ComponentDescription description = componentOf(job);
  io::RigTolerances tolerances = description.rig.value_or(io::RigTolerances{});
  for (const auto& [key, value] : job.options.rig) {
    io::setRigTolerance(tolerances, key + "=" + value);
  }
  if (!job.options.rig.empty()) {
    description.rig = tolerances;
  }
  diagnosis::DiagnosisOptions settings;
  settings.evidence = job.options.evidence;
  settings.threads = 1;  // the jobs themselves run side by side
  const diagnosis::Diagnosis result =
      diagnosis::diagnose(description, logs(job, job.logs), logs(job, job.hold_out), settings);
  record.values = diagnosisValues(result);
  record.evidence = diagnosisEvidence(result);
  if (job.options.reports == Reports::full) {
    diagnosis::writeReport(result, makeReportFolder(job));
  } else if (job.options.reports == Reports::data) {
    const std::string folder = makeReportFolder(job);
    log::writeNewFile(folder + "/report.json", diagnosis::toJson(result));
    if (result.workings) {
      log::writeNewFile(folder + "/augmented.yaml", diagnosis::augmentedYaml(result));
    }
    if (const std::string evidence = diagnosis::evidenceJson(result); !evidence.empty()) {
      log::writeNewFile(folder + "/evidence.json", evidence);
    }
  }
}

void Executor::estimate(const Job& job, Record& record) {
  const io::ComponentDescription description = componentOf(job);
  fit::IdentificationOptions settings;
  settings.held = job.options.hold;
  settings.starts = job.options.starts > 0 ? job.options.starts : settings.starts;
  const fit::Identification result = command::identifyFromLogs(description, logs(job, job.logs), settings);
  record.values = {{"residual_n", number(result.residual)}, {"relative_residual", number(result.relative_residual)}};
  ordered_json parameters = ordered_json::array();
  for (const fit::IdentifiedParameter& parameter : result.parameters) {
    const std::string name = fmt::format("{}_{}.{}", parameter.element, parameter.index, parameter.name);
    record.values[name] = number(parameter.value);
    record.values[name + "_lower"] = number(parameter.lower);
    record.values[name + "_upper"] = number(parameter.upper);
    parameters.push_back({{"name", name},
                          {"value", number(parameter.value)},
                          {"lower", number(parameter.lower)},
                          {"upper", number(parameter.upper)},
                          {"given", number(parameter.given)},
                          {"determined", parameter.determined}});
  }
  record.evidence = {{"parameters", parameters}};
  if (job.options.reports != Reports::none) {
    const std::string folder = makeReportFolder(job);
    log::writeNewFile(folder + "/identification.json", command::toJson(description.name, result));
    log::writeNewFile(folder + "/component.yaml", io::toYaml({command::identifiedComponent(description, result)}));
  }
}

void Executor::replay(const Job& job, Record& record) {
  const io::ComponentDescription description = componentOf(job);
  const log::Log& log = keptLog(job, job.logs.front());
  const gap::Replay result = gap::replay(description.makeComponent(), log);
  record.values = replayValues(log, result);
  if (job.options.reports != Reports::none) {
    log::writeForceCsv(makeReportFolder(job) + "/force.csv", log, result.force);
  }
}

io::ComponentDescription Executor::componentOf(const Job& job) {
  auto kept = std::find_if(kept_configs_.begin(), kept_configs_.end(),
                           [&](const KeptConfig& config) { return config.input == job.config; });
  if (kept == kept_configs_.end()) {
    const InputFile& input = manifest_.inputs[job.config];
    requireUnchanged(input);
    kept_configs_.push_front({job.config, io::loadComponentFile(input.path)});
    kept = kept_configs_.begin();
    if (kept_configs_.size() > kKeptConfigs) {
      kept_configs_.pop_back();
    }
  }
  io::ComponentDescription description = io::selectComponent(kept->components, job.component);
  if (!job.specification.empty()) {
    estimation::Specification specification = description.written();
    for (const auto& [name, value] : job.specification) {
      specification.set(name, value);
    }
    description.specify(specification);
  }
  return description;
}

std::vector<log::Log> Executor::logs(const Job& job, const std::vector<std::size_t>& files) {
  std::vector<log::Log> result;
  for (const std::size_t file : files) {
    result.push_back(keptLog(job, file));
  }
  return result;
}

const log::Log& Executor::keptLog(const Job& job, std::size_t file) {
  const std::string key = fmt::format("{}\n{}\n{}", file, job.component, readingKey(job.options));
  const auto kept =
      std::find_if(kept_logs_.begin(), kept_logs_.end(), [&](const KeptLog& log) { return log.key == key; });
  if (kept != kept_logs_.end()) {
    kept_logs_.splice(kept_logs_.begin(), kept_logs_, kept);
    return kept_logs_.front().log;
  }
  const InputFile& input = manifest_.inputs[file];
  requireUnchanged(input);
  kept_logs_.push_front({key, read_log_(input.path, job.component, logFormat(job.options))});
  keepFewLogs();
  return kept_logs_.front().log;
}

void Executor::keepFewLogs() {
  std::size_t samples = 0;
  for (auto log = kept_logs_.begin(); log != kept_logs_.end(); ++log) {
    samples += log->log.size();
    if (samples > kKeptSamples && log != kept_logs_.begin()) {
      kept_logs_.erase(log, kept_logs_.end());
      return;
    }
  }
}

void Executor::requireUnchanged(const InputFile& input) const {
  const io::FileHash hash = io::hashFile(input.path);
  if (hash.sha256 != input.sha256) {
    throw std::runtime_error(fmt::format(
        "{}: has changed since `campaign make` ({} bytes then, {} now); accepted: the file as it was, or `campaign "
        "make` again",
        input.path, input.size, hash.size));
  }
}

// Made if missing; what an earlier try left there has the same names and is replaced.
std::string Executor::makeReportFolder(const Job& job) const {
  std::string folder = folder_ + "/" + reportFolder(job.id);
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) {
    throw std::runtime_error(folder + ": cannot be made: " + failure.message());
  }
  return folder;
}

void Executor::listFiles(const Job& job, Record& record) const {
  const fs::path folder = fs::path(folder_) / reportFolder(job.id);
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file() && name.front() != '.') {  // a hidden one is what a killed process was writing
      record.files[name] = entry.file_size();
    }
  }
}

}  // namespace rubber_suspension::campaign
