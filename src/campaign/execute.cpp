// Executes one job (diagnose, estimate --from-log or replay) and extracts its values for tables.
#include "campaign/execute.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>

#include "command/identify.h"
#include "diagnosis/report/augmented_yaml.h"
#include "element/each.h"
#include "element/refuse.h"
#include "io/output_files.h"
#include "io/sha256.h"
#include "log/new_file.h"
#include "log/text.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/gap/replay.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::campaign {
namespace {

namespace fs = std::filesystem;

using diagnosis::Verdict;
using nlohmann::ordered_json;

constexpr std::size_t kKeptSamples = 4000000;  // in all cached logs, which then need about 100 MB

// Returns sets of effects that the logs cannot distinguish, such as "friction | friction + creep".
std::string setsText(const std::vector<std::vector<std::string>>& sets) {
  return element::joined(sets, " | ", [](const auto& set) { return fmt::format("{}", fmt::join(set, " + ")); });
}

// Returns the effects of an alternative, or its verdict if it has none.
std::vector<std::string> effectsOf(const diagnosis::Alternative& other) {
  return other.effects.empty() ? std::vector<std::string>{toString(other.verdict)} : other.effects;
}

// Returns the values for the table of the campaign. Numbers that are not finite are written as null.
ordered_json diagnosisValues(const diagnosis::Diagnosis& d) {
  ordered_json values = {{"verdict", toString(d.answer.verdict)},
                         {"effects", log::join(d.answer.effects)},
                         {"confounded", setsText(d.answer.confounded)},
                         {"alternatives", setsText(element::each(d.answer.alternatives, effectsOf))},
                         {"gap_as_configured", d.gaps.unseen.as_configured},
                         {"gap_re_estimated", d.gaps.unseen.re_estimated},
                         {"gap_augmented", d.gaps.unseen.augmented},
                         {"noise_floor", d.gaps.unseen.noise_floor},
                         {"closed", d.gaps.closed},
                         {"closed_lower", d.gaps.closed_interval[0]},
                         {"closed_upper", d.gaps.closed_interval[1]},
                         {"rig_findings", d.rig_findings.size()},
                         {"sentence", d.sentence}};
  for (const auto& [name, ratio] : d.parameters.ratios) {
    values["ratio." + name] = ratio;
  }
  return values;
}

// Returns true if the re-estimated values are meaningful. A wrong sign, unit or column makes them meaningless, and an
// unexplained residual biases them. With an added effect, the values depend on the form of the effect, and count only
// if other values alone would also explain the logs.
bool hasValuesOfItsOwn(const diagnosis::Diagnosis& d) {
  const bool other_values_do =
      std::any_of(d.answer.alternatives.begin(), d.answer.alternatives.end(), [](const diagnosis::Alternative& other) {
        return other.effects.empty() && other.verdict == Verdict::parameter_error;
      });
  return d.answer.verdict != Verdict::check_bench && d.answer.verdict != Verdict::defect &&
         d.answer.verdict != Verdict::unknown && (d.answer.effects.empty() || other_values_do);
}

void addChange(const std::string& name, double ratio, Findings& findings) {
  if (std::isfinite(ratio) && ratio > 0.0) {
    findings.changes[name] = std::log(ratio);
  }
}

Findings findingsOf(const diagnosis::Diagnosis& d) {
  Findings findings{d.answer.verdict, d.answer.effects, {}};
  if (hasValuesOfItsOwn(d)) {
    for (const auto& [name, ratio] : d.parameters.ratios) {
      addChange(name, ratio, findings);
    }
  }
  return findings;
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
    values["gap"] = gap::relativeGap(log.force, replay.force, log.counts);
  }
  return values;
}

std::map<std::string, io::FileHash> filesIn(const std::string& folder) {
  std::map<std::string, io::FileHash> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file() && name.front() != '.') {  // hidden files are leftovers of killed processes
      files[name] = io::hashFile(entry.path());
    }
  }
  return files;
}

// Rethrows errors of the computer rather than of the job: lack of memory as std::bad_alloc, and lack of disk space or
// file descriptors. Many readers and writers report these only in the text of the error.
void rethrowOfTheMachine(const std::exception& error) {
  const auto tells = [text = std::string(error.what())](int code) {
    return text.find(std::strerror(code)) != std::string::npos;
  };
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr || tells(ENOMEM)) {
    throw std::bad_alloc();
  }
  constexpr std::array kCodes = {ENOSPC, EDQUOT, EFBIG, EIO, EMFILE, ENFILE, ESTALE};
  if (std::any_of(kCodes.begin(), kCodes.end(), tells)) {
    throw std::runtime_error(error.what());
  }
}

// Caches logs and the component file that was read last, because many jobs share them.
class Executor {
 public:
  Executor(std::string folder, const Manifest& manifest, LogReader read_log)
      : folder_(std::move(folder)), manifest_(manifest), read_log_(std::move(read_log)) {}

  Record execute(const Job& job) {
    const auto start = std::chrono::steady_clock::now();
    Record record;
    try {
      work(job, record);
    } catch (const std::exception& error) {
      rethrowOfTheMachine(error);
      const std::string reason = log::oneLine(error.what());
      record = {};
      record.error = reason.empty() ? "the job failed without an error message" : reason;
    }
    record.id = job.id;
    record.version = manifest_.version;
    record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    writeRecord(record, folder_);
    return record;
  }

 private:
  void work(const Job& job, Record& record) {
    constexpr std::array kWorks = {&Executor::diagnose, &Executor::estimate, &Executor::replay};
    (this->*kWorks.at(static_cast<std::size_t>(job.command)))(job, record);
    if (job.options.reports != Reports::none) {
      record.files = filesIn(makeReportFolder(job));
    }
  }

  void diagnose(const Job& job, Record& record) {
    io::ComponentDescription description = componentOf(job);
    for (const auto& [key, value] : job.options.rig) {
      io::RigTolerances tolerances = description.rig.value_or(io::RigTolerances{});
      io::setRigTolerance(tolerances, key + "=" + value);
      description.rig = tolerances;
    }
    diagnosis::DiagnosisOptions settings;
    settings.evidence = job.options.evidence;
    settings.excluded = job.options.exclude;
    settings.threads = 1;  // the jobs themselves run in parallel
    const diagnosis::Diagnosis result =
        diagnosis::diagnose(description, logs(job, job.logs), logs(job, job.hold_out), settings);
    record.values = diagnosisValues(result);
    record.findings = findingsOf(result);
    if (job.options.reports == Reports::full) {
      const std::string problem = diagnosis::writeReport(result, makeReportFolder(job));
      if (!problem.empty()) {
        fmt::print(stderr, "campaign: warning: {}\n", log::oneLine(problem));
      }
    } else if (job.options.reports == Reports::data) {
      const std::string folder = makeReportFolder(job);
      log::writeNewFile(folder + "/report.json", diagnosis::toJson(result));
      if (hasComponentFile(result)) {
        log::writeNewFile(folder + "/augmented.yaml", diagnosis::report::augmentedYaml(result));
      }
      if (const std::string evidence = diagnosis::evidenceJson(result); !evidence.empty()) {
        log::writeNewFile(folder + "/evidence.json", evidence);
      }
    }
  }

  void estimate(const Job& job, Record& record) {
    const io::ComponentDescription description = componentOf(job);
    fit::IdentificationOptions settings;
    settings.held = job.options.hold;
    settings.starts = job.options.starts > 0 ? job.options.starts : settings.starts;
    const fit::Identification result = command::identifyFromLogs(description, logs(job, job.logs), settings);
    record.values = {{"residual_n", result.residual}, {"relative_residual", result.relative_residual}};
    for (const fit::IdentifiedParameter& parameter : result.parameters) {
      const std::string name = fmt::format("{}_{}.{}", parameter.element, parameter.index, parameter.name);
      record.values[name] = parameter.value;
      record.values[name + "_lower"] = parameter.lower;
      record.values[name + "_upper"] = parameter.upper;
      if (parameter.determined) {
        addChange(name, parameter.value / parameter.given, record.findings);
      }
    }
    if (job.options.reports != Reports::none) {
      const std::string folder = makeReportFolder(job);
      log::writeNewFile(folder + "/identification.json", command::toJson(description.name, result));
      log::writeNewFile(folder + "/component.yaml", io::toYaml({command::identifiedComponent(description, result)}));
    }
  }

  void replay(const Job& job, Record& record) {
    const io::ComponentDescription description = componentOf(job);
    const log::Log& log = keptLog(job, job.logs.front());
    const gap::Replay result = gap::replay(description.makeComponent(), log);
    record.values = replayValues(log, result);
    if (job.options.reports != Reports::none) {
      log::writeForceCsv(makeReportFolder(job) + "/force.csv", log, result.force);
    }
  }

  io::ComponentDescription componentOf(const Job& job) {
    if (kept_config_ != job.config) {
      components_ = io::loadComponentFile(unchangedPath(job.config));
      kept_config_ = job.config;
    }
    io::ComponentDescription description = io::selectComponent(components_, job.component);
    if (!job.specification.empty()) {
      estimation::Specification specification = description.written();
      for (const auto& [name, value] : job.specification) {
        specification.set(name, value);
      }
      description.specify(specification);
    }
    return job.options.without_rig ? description.withoutRig() : description;
  }

  std::vector<log::Log> logs(const Job& job, const std::vector<std::size_t>& files) {
    return element::each(files, [&](std::size_t file) { return keptLog(job, file); });
  }

  const log::Log& keptLog(const Job& job, std::size_t file) {
    const std::string key = fmt::format("{}\n{}\n{}", file, job.component, ordered_json(job.options).dump());
    const auto kept = kept_logs_.find(key);
    if (kept != kept_logs_.end()) {
      return kept->second;
    }
    log::Log log = read_log_(unchangedPath(file), job.component, logFormat(job.options));
    if (kept_samples_ + log.size() > kKeptSamples) {
      kept_logs_.clear();
      kept_samples_ = 0;
    }
    kept_samples_ += log.size();
    return kept_logs_.emplace(key, std::move(log)).first->second;
  }

  // Creates the folder if it is missing. Files of an earlier attempt have the same names and are replaced.
  std::string makeReportFolder(const Job& job) const {
    std::string folder = folder_ + "/" + reportFolder(job.id);
    io::makeFolder(folder);
    return folder;
  }

  // Returns the path of an input. Throws std::runtime_error if the file has changed.
  std::string unchangedPath(std::size_t input) const {
    const InputFile& file = manifest_.inputs[input];
    const io::FileHash hash = io::hashFile(file.path);
    element::refuseIf<std::runtime_error>(hash.sha256 != file.content.sha256,
                                          "{}: has changed since `campaign make` (from {} to {} bytes); accepted: the "
                                          "unchanged file, or `campaign make` again",
                                          file.path, file.content.size, hash.size);
    return file.path;
  }

  std::string folder_;
  const Manifest& manifest_;
  LogReader read_log_;
  std::map<std::string, log::Log> kept_logs_;
  std::size_t kept_samples_ = 0;
  std::optional<std::size_t> kept_config_;
  std::vector<io::ComponentDescription> components_;  // components of the file kept_config_
};

}  // namespace

std::function<Record(const Job&)> executorOf(const std::string& folder, const Manifest& manifest,
                                             const LogReader& read_log) {
  const auto executor = std::make_shared<Executor>(folder, manifest, read_log);
  return [executor](const Job& job) { return executor->execute(job); };
}

}  // namespace rubber_suspension::campaign
