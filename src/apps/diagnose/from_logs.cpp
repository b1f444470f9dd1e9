// diagnose from measured logs, of one direction or of several.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <set>
#include <utility>

#include "apps/diagnose/run.h"
#include "command_line/command.h"
#include "command_line/warnings.h"
#include "element/refuse.h"
#include "fit/parallel.h"
#include "io/folder_lock.h"
#include "log/text.h"
#include "rubber_suspension/diagnosis/six_directions.h"

namespace rubber_suspension::apps {
namespace {

using namespace command_line;

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
  OpenedLogs(const std::vector<std::string>& paths, const io::ComponentDescription& component,
             const DiagnoseOptions& options) {
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

  /// Findings in the logs once they were read.
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

diagnosis::ExperimentLimits limitsOf(const std::vector<std::string>& assignments) {
  diagnosis::ExperimentLimits limits;
  std::set<std::string> keys;
  for (const std::string& assignment : assignments) {
    const std::string key = log::trimmed(assignment.substr(0, assignment.find('=')));
    element::refuseIf<UsageError>(!keys.insert(key).second, "--limits: {} is given twice; accepted: once", key);
    asUsage("--limits: ", [&] { diagnosis::setExperimentLimit(limits, assignment); });
  }
  return limits;
}

// Settings of a search.
diagnosis::DiagnosisOptions settingsOf(const DiagnoseOptions& options) {
  diagnosis::DiagnosisOptions settings;
  settings.limits = limitsOf(options.limits);
  settings.most_samples = options.most_samples;
  settings.threads = options.threads;
  settings.progress = showStage;
  settings.evidence = options.evidence;
  settings.excluded = options.exclude;
  return settings;
}

// With the tolerances of the rig in the directions that are diagnosed.
io::ComponentDescription sixDirections(const DiagnoseOptions& options,
                                       const std::vector<component::Direction>& directions) {
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
                                       const DiagnoseOptions& options) {
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

// The component, which has one direction.
io::ComponentDescription oneDirection(const DiagnoseOptions& options) {
  io::ComponentDescription component = options.component.readAny("diagnose");
  if (component.six) {
    asUsage(fmt::format("{}: component '{}' ", options.component.config, component.name),
            [&] { diagnosis::requireDirections(component, {}); });
  }
  setTolerances(options.rig, component);
  return component;
}

}  // namespace

int runDirections(const DiagnoseOptions& options) {
  std::vector<component::Direction> directions;
  for (const std::string& name : options.directions) {
    const component::Direction direction = *component::directionFromString(name);
    element::refuseIf<UsageError>(std::find(directions.begin(), directions.end(), direction) != directions.end(),
                                  "--direction: {} is given twice; accepted: once", name);
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
  const std::string page = writtenReport(options.output, "report", diagnosis::writeReports(result, options.output));
  clearStage();
  for (const auto& [direction, diagnosis] : result.directions) {
    fmt::print("{}: {}\n{}", toString(direction), log::oneLine(diagnosis.sentence), excerptsTaken(diagnosis));
  }
  fmt::print("{}\n{}report: {}\n", diagnosis::crossMapSentence(result), diagnosis::crossMapText(result), page);
  const bool sound = std::all_of(result.directions.begin(), result.directions.end(),
                                 [](const auto& direction) { return direction.diagnosis.defect.empty(); });
  return sound ? kSuccess : kDefect;
}

int runLogs(const DiagnoseOptions& options) {
  diagnosis::DiagnosisOptions settings = settingsOf(options);
  const io::FolderLock lock(options.output);
  const io::ComponentDescription component = oneDirection(options);
  const std::optional<diagnosis::report::EarlierReport> earlier = earlierReport(options);
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

}  // namespace rubber_suspension::apps
