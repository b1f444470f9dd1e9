// diagnose: where the simulation differs from measured logs, which unmodelled effect causes it, how far the gap
// shrinks.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "command/measured_table.h"
#include "command_line/command.h"
#include "command_line/component_options.h"
#include "command_line/log_options.h"
#include "command_line/plot_option.h"
#include "command_line/warnings.h"
#include "diagnosis/report/compare.h"
#include "diagnosis/report/report_figures.h"
#include "diagnosis/report/run_record.h"
#include "diagnosis/results/model_values.h"
#include "diagnosis/results/taken_out.h"
#include "fit/parallel.h"
#include "io/folder_lock.h"
#include "io/progress.h"
#include "log/text.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/diagnosis/plan.h"
#include "rubber_suspension/diagnosis/six_directions.h"
#include "rubber_suspension/diagnosis/table_diagnosis.h"
#include "rubber_suspension/element/constants.h"

namespace {

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

struct Options {
  std::vector<std::string> command_line;
  ComponentOptions component;
  std::vector<std::string> directions;
  std::vector<std::string> logs;
  std::vector<std::string> hold_out;
  std::string output;
  std::string plot;
  std::string compare;
  bool evidence = false;
  std::string law = "simplest";
  std::vector<std::string> rig;
  std::vector<std::string> limits;
  std::vector<std::string> plan;
  std::string table_path;
  std::vector<std::string> uncertainty;
  double effect_size = 0.1;  // of the standard deviation of the force
  double noise = 0.005;      // likewise
  std::uint64_t most_samples = diagnosis::kMostSamples;
  int threads = 2;
  LogOptions log_options;

  OptionTable table();
};

// A share such as "10 %" or 0.1, within these bounds.
Quantity share(double& value, double least, double most) {
  return {
      &value, "1", element::Range::closed(least, most),
      fmt::format("a share of the force from {:g} to {:g} %, such as \"1 %\" or 0.01", 100.0 * least, 100.0 * most)};
}

io::FileKind kindOf(const std::string& name) {
  if (name == "plan.json") {
    return io::FileKind::plan_json;
  }
  if (name == "plan.html") {
    return io::FileKind::plan_html;
  }
  if (name == "report.json" || name == "evidence.json") {
    return io::FileKind::report_json;
  }
  const std::string extension = std::filesystem::path(name).extension().string();
  if (extension == ".html") {
    return io::FileKind::report_html;
  }
  if (extension == ".yaml") {
    return io::FileKind::component_file;
  }
  if (name == "missing_force.csv") {
    return io::FileKind::force_map_csv;
  }
  return name == "next_experiment.csv" ? io::FileKind::force_csv : io::FileKind::figure_csv;
}

// The files of the report, and those that stand beside it where the diagnosis has reason to write them.
Files reportFiles(const Options& options) {
  Files files;
  const auto add = [&](const std::filesystem::path& folder, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      files.outputs.push_back({"--output", (folder / name).string(), kindOf(name)});
    }
  };
  if (options.directions.empty()) {
    add(options.output, options.plan.empty() ? diagnosis::reportFiles() : diagnosis::planFiles());
    return files;
  }
  add(options.output, diagnosis::sixDirectionsFiles());
  for (const std::string& direction : std::set<std::string>(options.directions.begin(), options.directions.end())) {
    add(std::filesystem::path(options.output) / direction, diagnosis::reportFiles());
  }
  return files;
}

OptionTable Options::table() {
  OptionTable options = {
      component.table(),
      Option("--direction", directions, "NAME",
             "of six directions: which to diagnose; the report of each goes into a folder of its name, and a map says "
             "where they couple")
          .oneOf({"x", "y", "z", "rx", "ry", "rz"}),
      Option("--log", logs, "FILE",
             "measured logs of one component in the order of recording; text (CSV), .mat, HDF5 or .bag")
          .readsEachOnce(),
      Option("--plan", plan, "FILE",
             "instead of --log: programmes with time and displacement alone; says which effects such logs would show, "
             "which they would take for which, and the least size that they would show")
          .readsEachOnce(),
      Option("--from-table", table_path, "FILE",
             "instead of --log: measured table of stiffness and loss angle over frequency and amplitude; with mean "
             "displacement and temperature where it has them")
          .reads(),
      Option("--uncertainty", uncertainty, "SHARE ANGLE",
             "with --from-table: standard deviation of its stiffness and of its loss angle, such as \"1 %\" "
             "\"0.5 deg\"; where not given, repeated rows tell, or what a smooth surface leaves")
          .rare()
          .values(1, 2),
      Option("--effect-size", share(effect_size, 1e-4, 1.0), "SHARE",
             "with --plan: size of each effect, as a share of the force's standard deviation")
          .rare()
          .defaultText("10 %"),
      Option("--noise", share(noise, 1e-6, 1.0), "SHARE",
             "with --plan: noise of the force to be measured, as such a share")
          .rare()
          .defaultText("0.5 %"),
      Option("--hold-out", hold_out, "FILE", "logs that take no part in the fit; each starts with a new component")
          .readsEachOnce(),
      Option("--rig", rig, "KEY=VALUE",
             "what the rig may do to a log without being a cause; such as force_zero=\"50 N\" or gain=\"1 %\"; see "
             "`rig:` of component files"),
      Option("--limits", limits, "KEY=VALUE",
             "what the machine may do in the next experiment, such as stroke=\"20 mm\" speed=\"0.3 m/s\" "
             "frequency=\"15 Hz\" force=\"30 kN\" duration=\"60 s\"; where not given, what the logs reached")
          .rare(),
      Option("--output", output, "FOLDER", "folder of the report; made if missing").required().standsFor([this] {
        return reportFiles(*this);
      }),
      Option("--compare", compare, "FILE",
             "report.json of an earlier diagnosis: says what changed since, beyond noise and intervals")
          .rare()
          .reads(),
      Option("--evidence", evidence,
             "also write evidence.json: what every hypothesis leaves, of which the judgement is made")
          .rare(),
      Option(
          "--law", law, "LAW",
          "full: also write augmented_full.yaml, the laws with all numbers that were judged; simplest: augmented.yaml "
          "alone, whose laws have few numbers and leave nearly as little")
          .rare()
          .oneOf({"simplest", "full"}),
      plotOption(plot, "loops, residuals and the gap").rare(),
      Option("--most-samples", most_samples, "COUNT",
             "samples that the search takes, of all logs together; of longer logs it takes excerpts of all their "
             "amplitudes")
          .rare()
          .within(1000, 100000000),
      Option("--threads", threads, "COUNT", "number of threads").rare().within(1, 64),
      log_options.acceptUnits(),
      log_options.table()};
  options.needs({"--effect-size", "--noise"}, {"--plan"});
  options.excludes(
      {"--log", "--from-table", "--hold-out", "--limits", "--compare", "--plot", "--most-samples", "--accept-units"},
      {"--plan"});
  options.excludes({"--plan", "--from-table", "--compare", "--plot"}, {"--direction"});
  options.needs({"--uncertainty"}, {"--from-table"});
  options.excludes({"--log", "--hold-out", "--limits", "--most-samples"}, {"--from-table"});
  return options.excludes(LogOptions::names(), {"--from-table"});
}

std::vector<log::Log> readLogs(const std::vector<std::string>& paths, const io::ComponentDescription& component,
                               const Options& options) {
  std::vector<std::vector<log::Log>> of_path(paths.size());
  fit::parallelFor(paths.size(), options.threads,
                   [&](std::size_t i) { of_path[i] = options.log_options.readAll(paths[i], component.name); });
  std::vector<log::Log> logs;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    for (log::Log& log : of_path[i]) {
      LogOptions::printNotes("diagnose", paths[i], log.notes);
      warnOfTemperature("diagnose", paths[i], !log.temperature.empty(), component);
      logs.push_back(std::move(log));
    }
  }
  return logs;
}

// A log that remembers what its first reader was told.
class RememberedLog : public log::LogSource {
 public:
  explicit RememberedLog(std::shared_ptr<const log::LogSource> log) : log_(std::move(log)) {}

  std::string name() const override { return log_->name(); }

  std::vector<std::string> read(const Take& take) const override {
    bool all = true;
    bool has_temperature = false;
    std::vector<std::string> notes = log_->read([&](const log::Log& block, std::size_t first) {
      has_temperature = !block.temperature.empty();
      all = take(block, first);
      return all;
    });
    if (all) {
      const std::lock_guard<std::mutex> lock(mutex_);
      notes_ = notes;
      has_temperature_ = has_temperature;
    }
    return notes;
  }

  /// To stderr.
  void tell(const std::string& path, const io::ComponentDescription& component) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    LogOptions::printNotes("diagnose", path, notes_);
    warnOfTemperature("diagnose", path, has_temperature_, component);
  }

  bool hasTemperature() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return has_temperature_;
  }

 private:
  std::shared_ptr<const log::LogSource> log_;
  mutable std::mutex mutex_;
  mutable std::vector<std::string> notes_;
  mutable bool has_temperature_ = true;
};

// Logs to be diagnosed, which may be longer than memory.
class OpenedLogs {
 public:
  OpenedLogs(const std::vector<std::string>& paths, const io::ComponentDescription& component, const Options& options) {
    std::vector<log::LogSources> of_path(paths.size());
    fit::parallelFor(paths.size(), options.threads,
                     [&](std::size_t i) { of_path[i] = options.log_options.openAll(paths[i], component.name); });
    for (std::size_t i = 0; i < paths.size(); ++i) {
      for (const auto& log : of_path[i]) {
        logs_.push_back(std::make_shared<RememberedLog>(log));
        paths_.push_back(paths[i]);
      }
    }
  }

  log::LogSources sources() const { return {logs_.begin(), logs_.end()}; }

  /// What was found in the logs once they were read.
  void tell(const io::ComponentDescription& component) const {
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      logs_[i]->tell(paths_[i], component);
    }
  }

  /// File and whether it has a temperature, once the logs were read.
  void addTemperatures(std::vector<std::pair<std::string, bool>>& having) const {
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      having.emplace_back(paths_[i], logs_[i]->hasTemperature());
    }
  }

 private:
  std::vector<std::string> paths_;  // of each log
  std::vector<std::shared_ptr<RememberedLog>> logs_;
};

// One log without is enough that nothing can be said of heat.
void warnOfSomeTemperatures(const OpenedLogs& logs, const OpenedLogs& hold_out) {
  std::vector<std::pair<std::string, bool>> having;
  logs.addTemperatures(having);
  hold_out.addTemperatures(having);
  const auto has = [](const auto& log) { return log.second; };
  const auto one = std::find_if(having.begin(), having.end(), has);
  const auto other = std::find_if_not(having.begin(), having.end(), has);
  if (one != having.end() && other != having.end()) {
    printWarning("diagnose",
                 fmt::format("{} has no column temperature_degC, and {} has one: effects of temperature are "
                             "told only where all logs have it",
                             other->first, one->first));
  }
}

void showStage(const std::string& stage, double fraction) {
  if (isatty(STDERR_FILENO) != 0) {
    fmt::print(stderr, "\r\033[K[{:3.0f} %] {}", 100.0 * fraction, stage);
  }
}

void clearStage() {
  if (isatty(STDERR_FILENO) != 0) {
    fmt::print(stderr, "\r\033[K");
  }
}

// Version, date, command line and every file that is read.
diagnosis::RunRecord runRecord(const Options& options) {
  std::vector<std::pair<std::string, std::string>> files = {{"--config", options.component.config}};
  const auto add = [&](const std::string& option, const std::vector<std::string>& paths) {
    for (const std::string& path : paths) {
      if (!path.empty()) {
        files.emplace_back(option, path);
      }
    }
  };
  add("--compare", {options.compare});
  add("--log", options.logs);
  add("--plan", options.plan);
  add("--from-table", {options.table_path});
  add("--hold-out", options.hold_out);
  return diagnosis::makeRunRecord(version(), options.command_line, files);
}

void setTolerances(const std::vector<std::string>& assignments, io::ComponentDescription& component) {
  io::RigTolerances tolerances = component.rig.value_or(io::RigTolerances{});
  try {
    for (const std::string& assignment : assignments) {
      io::setRigTolerance(tolerances, assignment);
    }
  } catch (const std::invalid_argument& error) {
    throw UsageError("--rig: " + std::string(error.what()));
  }
  if (!assignments.empty()) {
    component.rig = tolerances;
  }
}

diagnosis::ExperimentLimits limitsOf(const std::vector<std::string>& assignments) {
  diagnosis::ExperimentLimits limits;
  std::set<std::string> keys;
  try {
    for (const std::string& assignment : assignments) {
      const std::string key = log::trimmed(assignment.substr(0, assignment.find('=')));
      if (!keys.insert(key).second) {
        throw std::invalid_argument(key + " is given twice; accepted: once");
      }
      diagnosis::setExperimentLimit(limits, assignment);
    }
  } catch (const std::invalid_argument& error) {
    throw UsageError("--limits: " + std::string(error.what()));
  }
  return limits;
}

int runPlan(const Options& options) {
  diagnosis::PlanOptions settings;
  settings.size = options.effect_size;
  settings.noise = options.noise;
  settings.threads = options.threads;
  options.log_options.requireUse(options.plan);
  io::ComponentDescription component = options.component.read("diagnose");
  setTolerances(options.rig, component);
  const std::vector<log::Log> programmes = readLogs(options.plan, component, options);
  std::optional<io::Activity> planning("finding what the programmes would show");
  diagnosis::Plan plan = diagnosis::plan(component, programmes, settings);
  plan.run = runRecord(options);
  diagnosis::writePlan(plan, options.output);
  planning.reset();
  fmt::print("{}plan: {}/plan.html\n", diagnosis::toText(plan.could_show), options.output);
  return kSuccess;
}

std::string excerptsTaken(const diagnosis::Diagnosis& diagnosis) {
  return diagnosis.samples == diagnosis.recorded_samples
             ? ""
             : fmt::format("excerpts: {} of {} samples were searched (--most-samples)\n", diagnosis.samples,
                           diagnosis.recorded_samples);
}

std::string takenOut(const diagnosis::Diagnosis& diagnosis) {
  const std::vector<std::string> phrases = diagnosis::describeTakenOut(diagnosis.taken_out);
  return phrases.empty() ? "" : log::oneLine(fmt::format("taken out of the logs: {}", fmt::join(phrases, "; "))) + "\n";
}

std::optional<diagnosis::EarlierReport> earlierReport(const Options& options) {
  return options.compare.empty() ? std::nullopt : std::optional<diagnosis::EarlierReport>(options.compare);
}

// Writes the report of a diagnosis, and says on the terminal what it comes to.
int publish(diagnosis::Diagnosis diagnosis, const std::optional<diagnosis::EarlierReport>& earlier,
            const Options& options) {
  diagnosis.run = runRecord(options);
  diagnosis.write_full_law = options.law == "full";
  if (earlier) {
    diagnosis.comparison = earlier->compare(diagnosis);
  }
  showStage("writing the report", 0.95);
  diagnosis::writeReport(diagnosis, options.output);
  if (!options.plot.empty() && diagnosis.workings) {
    io::drawFigure(diagnosis::overviewFigure(diagnosis), options.plot);
  }
  clearStage();
  const std::string whole = diagnosis::wholeText(diagnosis);
  fmt::print("{}\n{}{}{}{}report: {}/report.html\n", log::oneLine(diagnosis.sentence),
             whole.empty() ? "" : whole + "\n", takenOut(diagnosis), excerptsTaken(diagnosis),
             toText(diagnosis.comparison), options.output);
  return kSuccess;
}

// Of K*, from that of the stiffness and that of the loss angle: they stand at right angles to each other.
std::optional<double> uncertaintyOf(const std::vector<std::string>& texts) {
  if (texts.empty()) {
    return std::nullopt;
  }
  constexpr double kMostDegrees = 45.0;
  double of_stiffness = 0.0;
  double of_angle = 0.0;
  of_stiffness = quantityOf("--uncertainty", texts[0], share(of_stiffness, 1e-4, 1.0));
  if (texts.size() > 1) {
    of_angle = quantityOf("--uncertainty", texts[1],
                          {&of_angle, "rad", element::Range::closed(0.0, kMostDegrees * element::kPi / 180.0),
                           fmt::format("an angle from 0 to {:g} degrees, such as \"0.5 deg\"", kMostDegrees)});
  }
  return std::hypot(of_stiffness, of_angle);
}

int runTable(const Options& options) {
  const std::optional<double> uncertainty = uncertaintyOf(options.uncertainty);
  const io::FolderLock lock(options.output);
  io::ComponentDescription component = options.component.read("diagnose");
  setTolerances(options.rig, component);
  const std::optional<diagnosis::EarlierReport> earlier = earlierReport(options);
  fit::MeasuredTable table = command::readTable(options.table_path);
  table.uncertainty = uncertainty;
  table.accept_units = options.log_options.acceptsUnits();
  for (const std::string& note : table.notes) {
    printWarning("diagnose", options.table_path + ": " + note);
  }
  diagnosis::DiagnosisOptions settings;
  settings.threads = options.threads;
  settings.progress = showStage;
  settings.evidence = options.evidence;
  return publish(diagnosis::diagnoseTable(component, table, settings), earlier, options);
}

// What a search is told.
diagnosis::DiagnosisOptions settingsOf(const Options& options) {
  diagnosis::DiagnosisOptions settings;
  settings.limits = limitsOf(options.limits);
  settings.most_samples = options.most_samples;
  settings.threads = options.threads;
  settings.progress = showStage;
  settings.evidence = options.evidence;
  return settings;
}

// With the tolerances of the rig in the directions that are diagnosed.
io::ComponentDescription sixDirections(const Options& options, const std::vector<component::Direction>& directions) {
  io::ComponentDescription component = options.component.readAny("diagnose");
  try {
    diagnosis::requireDirections(component, directions);
  } catch (const std::invalid_argument& error) {
    throw io::ComponentFileError(
        fmt::format("{}: component '{}': {}", options.component.config, component.name, error.what()));
  }
  auto six = std::make_shared<io::SixDirectionsDescription>(*component.six);
  for (const component::Direction direction : directions) {
    setTolerances(options.rig, *six->directions[direction]);
  }
  component.six = std::move(six);
  return component;
}

std::vector<log::PoseLog> readPoseLogs(const std::vector<std::string>& paths, const io::ComponentDescription& component,
                                       const Options& options) {
  std::vector<log::PoseLog> logs;
  for (const std::string& path : paths) {
    logs.push_back(options.log_options.readPoses("diagnose", path, component.name, component.six->arrangement.measure));
    for (const auto& direction : component.six->directions) {
      if (direction && direction->temperature) {
        warnOfTemperature("diagnose", path, !logs.back().temperature.empty(), *direction);
        break;
      }
    }
  }
  return logs;
}

int runDirections(const Options& options) {
  std::vector<component::Direction> directions;
  for (const std::string& name : options.directions) {
    const component::Direction direction = *component::directionFromString(name);
    if (std::find(directions.begin(), directions.end(), direction) != directions.end()) {
      throw UsageError("--direction: " + name + " is given twice; accepted: once");
    }
    directions.push_back(direction);
  }
  const diagnosis::DiagnosisOptions settings = settingsOf(options);
  const io::FolderLock lock(options.output);
  const io::ComponentDescription component = sixDirections(options, directions);
  const std::vector<log::PoseLog> logs = readPoseLogs(options.logs, component, options);
  const std::vector<log::PoseLog> hold_out = readPoseLogs(options.hold_out, component, options);
  diagnosis::SixDirectionsDiagnosis result =
      diagnosis::diagnoseDirections(component, directions, logs, hold_out, settings);
  result.run = runRecord(options);
  for (auto& [direction, diagnosis] : result.directions) {
    diagnosis.run = result.run;
    diagnosis.write_full_law = options.law == "full";
  }
  showStage("writing the reports", 0.95);
  diagnosis::writeReports(result, options.output);
  clearStage();
  for (const auto& [direction, diagnosis] : result.directions) {
    fmt::print("{}: {}\n{}", toString(direction), log::oneLine(diagnosis.sentence), excerptsTaken(diagnosis));
  }
  fmt::print("{}\n{}report: {}/report.html\n", diagnosis::crossMapSentence(result), diagnosis::crossMapText(result),
             options.output);
  return kSuccess;
}

// The component, which has one direction.
io::ComponentDescription oneDirection(const Options& options) {
  io::ComponentDescription component = options.component.readAny("diagnose");
  if (component.six) {
    try {
      diagnosis::requireDirections(component, {});
    } catch (const std::invalid_argument& error) {
      throw UsageError(fmt::format("{}: component '{}' {}", options.component.config, component.name, error.what()));
    }
  }
  setTolerances(options.rig, component);
  return component;
}

int run(const Options& options) {
  if (!options.plan.empty()) {
    return runPlan(options);
  }
  if (!options.table_path.empty()) {
    return runTable(options);
  }
  if (options.logs.empty()) {
    throw UsageError(
        "--log is missing; accepted: measured logs, --from-table with a table of stiffness and loss angle, or --plan "
        "with programmes of displacement");
  }
  std::vector<std::string> all_logs = options.logs;
  all_logs.insert(all_logs.end(), options.hold_out.begin(), options.hold_out.end());
  options.log_options.requireUse(all_logs);
  if (!options.directions.empty()) {
    return runDirections(options);
  }
  diagnosis::DiagnosisOptions settings = settingsOf(options);
  const io::FolderLock lock(options.output);
  const io::ComponentDescription component = oneDirection(options);
  const std::optional<diagnosis::EarlierReport> earlier = earlierReport(options);
  showStage("reading the logs", 0.0);
  const OpenedLogs logs(options.logs, component, options);
  const OpenedLogs hold_out(options.hold_out, component, options);
  auto tell = [&, told = false]() mutable {
    if (!told) {
      logs.tell(component);
      hold_out.tell(component);
      warnOfSomeTemperatures(logs, hold_out);
    }
    told = true;
  };
  settings.progress = [&tell](const std::string& stage, double fraction) {
    tell();  // before the search, which takes longest
    showStage(stage, fraction);
  };
  diagnosis::Diagnosis diagnosis = diagnosis::diagnose(component, logs.sources(), hold_out.sources(), settings);
  tell();  // where nothing was searched
  return publish(std::move(diagnosis), earlier, options);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  options.command_line = {"rosrun", "rubber_suspension", "diagnose"};
  options.command_line.insert(options.command_line.end(), argv + std::min(argc, 1), argv + argc);
  return runCommand(
      argc, argv,
      {"diagnose",
       "Finds where a model differs from logs, which effect is missing, and how far it closes the gap.",
       {{"What a model lacks against two logs", "--config component.yaml --log log.csv log_2.csv --output report"},
        {"On a rig whose force sensor has a zero error of up to 50 N",
         "--config component.yaml --log log.csv --rig force_zero=\"50 N\" --output report"},
        {"Which effects a programme would show", "--config component.yaml --plan programme.csv --output plan"}}},
      options.table(), [&] { return run(options); });
}
