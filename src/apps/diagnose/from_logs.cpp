// Runs `diagnose` with measured logs of one direction or of several.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "apps/diagnose/run.h"
#include "command_line/command.h"
#include "command_line/warnings.h"
#include "diagnosis/surveyed_logs.h"
#include "element/refuse.h"
#include "fit/parallel.h"
#include "io/folder_lock.h"
#include "log/text.h"
#include "rubber_suspension/diagnosis/six_directions.h"

namespace rubber_suspension::apps {
namespace {

using namespace command_line;

using Surveys = std::vector<diagnosis::prepare::LogSurvey>;

// The logs to be diagnosed, which may be larger than memory, and the path of each.
struct OpenedLogs {
  std::vector<std::string> paths;
  log::LogSources sources;
};

OpenedLogs openLogs(const std::vector<std::string>& paths, const io::ComponentDescription& component,
                    const DiagnoseOptions& options) {
  std::vector<log::LogSources> of_path(paths.size());
  fit::parallelFor(paths.size(), options.threads,
                   [&](std::size_t i) { of_path[i] = options.log_options.openAll(paths[i], component.name); });
  OpenedLogs opened;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    opened.paths.insert(opened.paths.end(), of_path[i].size(), paths[i]);
    opened.sources.insert(opened.sources.end(), of_path[i].begin(), of_path[i].end());
  }
  return opened;
}

// The path of each log, and true if the log has a temperature.
using Temperatures = std::vector<std::pair<std::string, bool>>;

// Prints the notes on the logs, and appends an entry for each log to `temperatures`.
void printNotes(const OpenedLogs& logs, const Surveys& surveys, const io::ComponentDescription& component,
                Temperatures& temperatures) {
  for (std::size_t i = 0; i < surveys.size(); ++i) {
    LogOptions::printNotes("diagnose", logs.paths[i], surveys[i].notes);
    warnOfTemperature("diagnose", logs.paths[i], surveys[i].has_temperature, component);
    temperatures.emplace_back(logs.paths[i], surveys[i].has_temperature);
  }
}

// Warns if only some logs have a temperature, because effects of temperature are found only if all logs have one.
void warnOfSomeTemperatures(const Temperatures& temperatures) {
  const auto has = [](const auto& log) { return log.second; };
  const auto one = std::find_if(temperatures.begin(), temperatures.end(), has);
  const auto other = std::find_if_not(temperatures.begin(), temperatures.end(), has);
  if (one != temperatures.end() && other != temperatures.end()) {
    printWarning("diagnose", fmt::format("{} has no column temperature_degC, but {} has one: effects of temperature "
                                         "are found only if all logs have this column",
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

// Returns the component, with the tolerances of --rig in the directions that are to be diagnosed.
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

// Returns the component. Throws UsageError if it has six directions.
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
  const diagnosis::DiagnosisOptions settings = settingsOf(options);
  const io::FolderLock lock(options.output);
  const io::ComponentDescription component = oneDirection(options);
  const std::optional<diagnosis::report::EarlierReport> earlier = earlierReport(options);
  showStage("reading the logs", 0.0);
  const OpenedLogs logs = openLogs(options.logs, component, options);
  const OpenedLogs hold_out = openLogs(options.hold_out, component, options);
  const diagnosis::SurveyedLogs read = diagnosis::surveyed(component, logs.sources, hold_out.sources, options.threads);
  Temperatures temperatures;
  printNotes(logs, read.logs, component, temperatures);
  printNotes(hold_out, read.hold_out, component, temperatures);
  warnOfSomeTemperatures(temperatures);
  return publish(diagnosis::diagnose(component, read, settings), earlier, options);
}

}  // namespace rubber_suspension::apps
