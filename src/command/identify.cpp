// Computes and formats the report of `estimate --from-log`.
#include "command/identify.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "element/each.h"
#include "element/refuse.h"
#include "estimation/models.h"
#include "gap/last_cycles.h"
#include "gap/simulate.h"
#include "log/even_blocks.h"
#include "rubber_suspension/gap/replay.h"
#include "rubber_suspension/io/rig_tolerances.h"
#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/bench_check.h"
#include "rubber_suspension/measurement/faults.h"
#include "rubber_suspension/measurement/prepared_log.h"
#include "rubber_suspension/measurement/rig_model.h"

namespace rubber_suspension::command {
namespace {

std::string intervalText(const fit::IdentifiedParameter& parameter) {
  return std::isfinite(parameter.upper) ? fmt::format("{:.6g} to {:.6g}", parameter.lower, parameter.upper)
                                        : fmt::format("at least {:.6g}, no upper limit", parameter.lower);
}

std::string directionText(const fit::UndeterminedDirection& direction) {
  return element::joined(direction.weights, ", ",
                         [](const auto& one) { return fmt::format("{:+.2g} {}", one.second, one.first); });
}

nlohmann::ordered_json directionJson(const fit::UndeterminedDirection& direction) {
  auto weights = nlohmann::ordered_json::object();
  for (const auto& [name, weight] : direction.weights) {
    weights[name] = weight;
  }
  return {{"deviation", direction.standard_deviation}, {"weights", weights}};
}

nlohmann::ordered_json parameterJson(const fit::IdentifiedParameter& parameter) {
  return {{"element", parameter.element}, {"index", parameter.index},
          {"name", parameter.name},       {"unit", parameter.unit},
          {"value", parameter.value},     {"interval_95", {parameter.lower, parameter.upper}},
          {"given", parameter.given},     {"determined", parameter.determined}};
}

constexpr double kCycles = 5.0;  // number of cycles drawn of each log, because more would merge into one area

// Returns the distance between the samples that a figure shows, which keeps the file of the figure small.
std::size_t stride(std::size_t samples) { return 1 + samples / 4000; }

// Returns true if all logs have a temperature and the temperature varies. Only then is its effect determined.
bool showTemperature(const std::vector<log::Log>& logs) {
  const bool all = std::none_of(logs.begin(), logs.end(), [](const log::Log& log) { return log.temperature.empty(); });
  return all && std::any_of(logs.begin(), logs.end(), [&](const log::Log& log) {
           const double first = logs.front().temperature.front();
           return std::any_of(log.temperature.begin(), log.temperature.end(), [&](double t) { return t != first; });
         });
}

void holdShifts(const std::vector<element::ElementDescription>& elements, std::vector<std::string>& held) {
  for (const element::ElementDescription& description : elements) {
    const element::ElementPointer law = element::makeElement(description);
    if (element::lawOf(law).action() == element::Action::shifts_with_temperature) {
      for (const auto& [name, values] : element::complete(description).values) {
        held.push_back(description.type + "." + name);
      }
    }
  }
}

constexpr std::size_t kShortest = 100;  // smallest number of samples of a record

// For each log, the record of its longest stretch without a time gap; nullopt if this is too short.
using RecordsOfLogs = std::vector<std::optional<log::Record>>;

// The errors of the rig that were found in the logs.
struct RigOfLogs {
  std::vector<Eigen::MatrixXd> columns;  // as fit::IdentificationOptions::rig; empty if nothing was found
  std::vector<measurement::RigFinding> findings;
};

// Excludes gain, delays and displacement offset from the search, because they resemble the parameters to be identified.
io::RigTolerances withoutParameters(io::RigTolerances tolerances) {
  tolerances.gain = tolerances.delay = tolerances.clock = tolerances.displacement_zero = {0.0, false};
  return tolerances;
}

gap::Forces simulateOver(const std::vector<element::ElementDescription>& elements,
                         std::vector<gap::PreparedRecord> records, const std::vector<Eigen::VectorXd>& displacements) {
  for (std::size_t r = 0; r < records.size(); ++r) {
    records[r].displacement = displacements[r];
    records[r].raw_displacement = displacements[r];
  }
  return gap::simulateEach(elements, records);
}

// Returns the indices of the logs that have no time gap and as many samples as their record. Appends these records.
std::vector<std::size_t> usable(const std::vector<log::Log>& logs, const RecordsOfLogs& all,
                                std::vector<gap::PreparedRecord>& records) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    if (all[i] && static_cast<std::size_t>(all[i]->size()) == logs[i].size() && log::stretchesOf(logs[i]).size() == 1) {
      places.push_back(i);
      records.push_back(*all[i]);
    }
  }
  return places;
}

// Adds a column for the force offset of each log but the first. The fit itself has an offset that all logs share.
void addZeros(const std::vector<log::Log>& logs, std::vector<Eigen::MatrixXd>& columns) {
  for (std::size_t i = 1; i < logs.size(); ++i) {
    Eigen::MatrixXd wider(static_cast<Eigen::Index>(logs[i].size()), columns[i].cols() + 1);
    wider << columns[i], Eigen::VectorXd::Ones(wider.rows());
    columns[i] = wider;
  }
}

// Returns the logs with faulty samples replaced by linear interpolation. Appends the findings.
std::vector<log::Log> repairedLogs(const std::vector<log::Log>& logs, std::vector<measurement::RigFinding>& findings) {
  std::vector<log::Log> result = logs;
  for (log::Log& log : result) {
    if (log.size() < kShortest) {
      continue;
    }
    const measurement::Faults faults = measurement::findFaults(log);
    if (!faults.findings.empty()) {
      log = measurement::repaired(log, faults);
      findings.insert(findings.end(), faults.findings.begin(), faults.findings.end());
    }
  }
  return result;
}

RecordsOfLogs recordsOf(const std::vector<log::Log>& logs) {
  return element::each(logs, [](const log::Log& log) {
    const log::Log stretch = log::longestStretch(log);
    return stretch.size() < kShortest ? std::nullopt : std::optional(log::makeRecord(stretch));
  });
}

// Compares the logs with the simulated force of these elements. Finds force offsets that differ between logs, and
// forces that persist from motion before a log began. Skips logs that are too short or unevenly sampled.
RigOfLogs rigOfLogs(const std::vector<element::ElementDescription>& elements, const io::RigTolerances& tolerances,
                    const std::vector<log::Log>& logs, const RecordsOfLogs& all) {
  std::vector<gap::PreparedRecord> records;
  const std::vector<std::size_t> places = usable(logs, all, records);
  const gap::Forces simulated = gap::simulateEach(elements, records);
  const auto simulate = [&](const std::vector<Eigen::VectorXd>& displacements) {
    return simulateOver(elements, records, displacements);
  };
  const io::RigTolerances own = withoutParameters(tolerances);
  const measurement::RigModel rig(records, {}, own);
  const std::vector<measurement::RigFit> fits = rig.fitAll(simulated, simulate);
  RigOfLogs result;
  std::set<std::size_t> running;
  bool zeros = false;
  for (std::size_t r = 0; r < records.size(); ++r) {
    for (const measurement::RigFinding& finding : rig.findings(r, fits[r])) {
      const bool zero = finding.finding == measurement::finding::kForceZero && logs.size() > 1;
      const bool start = finding.finding == measurement::finding::kRunningStart;
      zeros = zeros || zero;
      if (start) {
        running.insert(r);
      }
      if (zero || start) {
        result.findings.push_back(finding);
      }
    }
  }
  if (result.findings.empty()) {
    return result;
  }
  const auto states = measurement::initialStates(records, own, simulated, simulate);
  result.columns.resize(logs.size());
  for (std::size_t i = 0; i < logs.size(); ++i) {
    result.columns[i].resize(static_cast<Eigen::Index>(logs[i].size()), 0);
  }
  for (const std::size_t r : running) {
    result.columns[places[r]] = states[r];
  }
  if (zeros) {
    addZeros(logs, result.columns);
  }
  return result;
}

// Throws for a reversed channel, exchanged columns, or a unit that is wrong by a factor of hundreds. The fit would
// explain these by a component without a spring. Smaller factors may be real and are only noted.
void checkBenchOf(const io::ComponentDescription& description, const RecordsOfLogs& all,
                  std::vector<std::string>& notes) {
  std::vector<log::Record> records;
  for (const auto& record : all) {
    if (record) {
      records.push_back(*record);
    }
  }
  for (const measurement::RigFinding& finding : measurement::checkBench(
           description.allElements(), records, estimation::largestTolerance(description.specification()))) {
    const bool of_stiffness = finding.finding == measurement::finding::kUnitFactor ||
                              finding.finding == measurement::finding::kOtherComponent ||
                              finding.finding == measurement::finding::kPeakToPeak;
    const bool short_log = finding.finding == measurement::finding::kTooShort;
    element::refuseIf<log::LogError>(!short_log && (!of_stiffness || measurement::isFarOff(finding)), "{}: {}",
                                     finding.log, finding.text);
    notes.push_back(finding.log + ": " + finding.text);
  }
}

}  // namespace

fit::Identification identifyFromLogs(const io::ComponentDescription& description, const std::vector<log::Log>& logs,
                                     fit::IdentificationOptions options) {
  for (const log::Log& log : logs) {
    log::requireForce(log);
  }
  const component::Component component = description.makeComponent();
  for (const log::Log& log : logs) {
    gap::checkTemperature(component, log);
  }
  if (!showTemperature(logs)) {
    holdShifts(description.allElements(), options.held);
  }
  const bool spread = description.model() == estimation::Model::multi_maxwell;
  if (spread) {
    options.held.emplace_back("maxwell.break_frequency");
  }
  std::vector<measurement::RigFinding> findings;
  const std::vector<log::Log> repaired = repairedLogs(logs, findings);
  std::vector<std::string> bench_notes;
  const RecordsOfLogs records = recordsOf(repaired);
  checkBenchOf(description, records, bench_notes);
  fit::Identification result = fit::identify(description.allElements(), repaired, options);
  // The forces that persist from earlier motion depend on the parameters. They are small, so that two fits suffice.
  constexpr int kLooks = 2;
  for (int look = 0; look < kLooks; ++look) {
    RigOfLogs rig = rigOfLogs(result.elements, description.rig.value_or(io::RigTolerances{}), repaired, records);
    if (look == 0) {
      findings.insert(findings.end(), rig.findings.begin(), rig.findings.end());
    }
    if (rig.columns.empty()) {
      break;
    }
    options.rig = std::move(rig.columns);
    result = fit::identify(description.allElements(), repaired, options);
  }
  if (result.elements.empty()) {
    throw log::LogError(fmt::format(
        "{}: no element of {} contributes to the force in {}; accepted: logs whose force rises with the displacement",
        logs.front().name, description.name, logs.size() == 1 ? "this log" : "these logs"));
  }
  result.notes.insert(result.notes.end(), bench_notes.begin(), bench_notes.end());
  for (const measurement::RigFinding& finding : findings) {
    result.notes.push_back(fmt::format("{}: {}", finding.log, finding.text));
  }
  if (spread) {
    result.notes.emplace_back("the break frequencies of multi_maxwell keep the values of the specification");
  }
  return result;
}

io::ComponentDescription identifiedComponent(const io::ComponentDescription& description,
                                             const fit::Identification& result) {
  return {description.name, result.elements};
}

std::string toText(const std::string& component, const fit::Identification& result) {
  std::string text =
      fmt::format("component {}, parameters from measured logs\n  {:<24} {:<22} {:>14} {}  95 % interval\n", component,
                  "element", "parameter", "value", "unit ");
  for (const fit::IdentifiedParameter& parameter : result.parameters) {
    text += fmt::format("  {:<24} {:<22} {:>14.6g} {:<6} {}{}\n", parameter.element, parameter.name, parameter.value,
                        parameter.unit, intervalText(parameter), parameter.determined ? "" : "  not determined");
  }
  text += fmt::format("  force offset {:.6g} N\n", result.force_offset);
  text += fmt::format(
      "  residual {:.6g} N, {:.3g} % of the force's standard deviation; equivalent to {:.0f} independent samples\n",
      result.residual, 100.0 * result.relative_residual, result.independent_samples);
  text += fmt::format("  {} of {} starting points led to this optimum\n", result.starts_at_best, result.starts);
  for (const fit::UndeterminedDirection& direction : result.undetermined) {
    text += fmt::format("  not determined: {} (these relative changes, made together, do not change the force{})\n",
                        directionText(direction),
                        std::isfinite(direction.standard_deviation)
                            ? fmt::format(" beyond its noise; standard deviation {:.2g}", direction.standard_deviation)
                            : "");
  }
  for (const std::string& note : result.notes) {
    text += "  note: " + note + "\n";
  }
  return text;
}

std::string toJson(const std::string& component, const fit::Identification& result) {
  const nlohmann::ordered_json json = {{"schema", "rubber_suspension/identification/1"},
                                       {"component", component},
                                       {"parameters", element::each(result.parameters, parameterJson)},
                                       {"force_offset_n", result.force_offset},
                                       {"residual_n", result.residual},
                                       {"relative_residual", result.relative_residual},
                                       {"independent_samples", result.independent_samples},
                                       {"starts", result.starts},
                                       {"starts_at_best", result.starts_at_best},
                                       {"undetermined", element::each(result.undetermined, directionJson)},
                                       {"notes", result.notes}};
  return json.dump(2) + "\n";
}

io::Figure identificationFigure(const io::ComponentDescription& description, const fit::Identification& result,
                                const std::vector<log::Log>& logs) {
  io::Figure figure{description.name + ": measured and fitted"};
  const component::Component component(result.elements);
  for (const log::Log& log : logs) {
    const std::vector<double> force = gap::replay(component, log).force;
    io::Axes loop{log.name, "displacement [mm]", "force [kN]"};
    io::Axes rest{log.name, "time [s]", "measured minus fitted [kN]"};
    // The measured curve is broad and lies beneath the thin fitted curve, so that both are visible.
    loop.curves = {{"measured", {}, {}, "-", 0, 2.8}, {"fitted", {}, {}, "-", io::kInk, 1.0}};
    rest.curves = {{"", {}, {}, "-", 4}};
    const std::size_t first = gap::firstOfLastCycles(log, gap::meanFrequency(log), kCycles);
    for (std::size_t i = first; i < log.size(); i += stride(log.size() - first)) {
      const double fitted = (force[i] + result.force_offset) * 1e-3;
      for (io::Curve& curve : loop.curves) {
        curve.x.push_back(log.displacement[i] * 1e3);
      }
      loop.curves[0].y.push_back(log.force[i] * 1e-3);
      loop.curves[1].y.push_back(fitted);
      rest.curves[0].x.push_back(log.time(i));
      rest.curves[0].y.push_back(log.force[i] * 1e-3 - fitted);
    }
    if (first > 0) {
      loop.title += ", last cycles";
    }
    figure.axes.push_back(loop);
    figure.axes.push_back(rest);
  }
  return figure;
}

}  // namespace rubber_suspension::command
