// Diagnoses each direction by itself, and computes how displacements predict residuals of other directions.
#include "rubber_suspension/diagnosis/six_directions.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "diagnosis/results/cross_map.h"
#include "rubber_suspension/element/radial_stiffness.h"
#include "rubber_suspension/gap/pose_replay.h"

namespace rubber_suspension::diagnosis {
namespace {

using component::Direction;
using SixLogs = std::array<log::Log, component::kDirections>;

// Returns true if a common radius couples the direction with others.
bool isCoupled(const component::SixDirectionsLaws& laws, Direction direction) {
  const component::Coupling coupling = component::isRotation(direction) ? laws.rotation : laws.translation;
  return coupling == component::Coupling::spherical ||
         (coupling == component::Coupling::cylindrical && direction % 3 != laws.axis);
}

// Returns the other direction perpendicular to the axis, with which this direction may share a radius. Returns nothing
// if that direction is free or has another factor of stiffness_by_preload.
std::optional<Direction> partnerOf(const io::SixDirectionsDescription& six, Direction direction) {
  const std::size_t own = direction % 3;
  const std::size_t axis = six.arrangement.axis;
  const auto other = static_cast<Direction>(direction - own + 3 - own - axis);
  const bool shares = own != axis && six.directions[other] && six.factorOf(other) == six.factorOf(direction);
  return shares ? std::optional(other) : std::nullopt;
}

std::string acceptedDirections(const io::SixDirectionsDescription& six) {
  std::string list;
  for (std::size_t i = 0; i < component::kDirections; ++i) {
    const auto direction = static_cast<Direction>(i);
    if (six.directions[i] && !isCoupled(six.arrangement, direction)) {
      list += (list.empty() ? "" : ", ") + std::string(toString(direction));
    }
  }
  return list;
}

void requireDirection(const io::SixDirectionsDescription& six, Direction direction) {
  const std::string accepted = acceptedDirections(six);
  const std::string others = accepted.empty() ? "" : "one of " + accepted;
  if (!six.directions[direction]) {
    throw std::invalid_argument(fmt::format("direction {}: is free; accepted: {}", toString(direction),
                                            others.empty() ? "a direction that the file defines" : others));
  }
  if (isCoupled(six.arrangement, direction)) {
    const char* const force = std::array{"Fx", "Fy", "Fz", "Mx", "My", "Mz"}[direction];
    throw std::invalid_argument(fmt::format(
        "direction {}: its force depends on a radius that it shares with other directions (key coupling); accepted: "
        "{}rectangular coupling; or, for a log along {} only, a component of one direction with --columns time=time "
        "displacement={} force={}",
        toString(direction), others.empty() ? "" : others + "; ", toString(direction), toString(direction), force));
  }
}

std::vector<SixLogs> measuredDirections(const component::SixDirections& component,
                                        const std::vector<log::PoseLog>& logs) {
  std::vector<SixLogs> directions;
  for (const log::PoseLog& log : logs) {
    if (log.wrench[0].empty()) {
      throw log::LogError(log.name +
                          ": the log has no measured wrench; accepted: a log with the columns Fx_N ... Mz_Nm, or a bag "
                          "with the topic measured_wrench");
    }
    directions.push_back(gap::directionLogs(component, log, log.wrench));
  }
  return directions;
}

// Returns the logs of a direction. Their force is divided by the factor of the direction, because the entries of the
// component file produce the force before this factor.
std::vector<log::Log> logsOf(const std::vector<SixLogs>& all, Direction direction,
                             const io::SixDirectionsDescription& six) {
  const double factor = six.factorOf(direction);
  const std::optional<Direction> partner = partnerOf(six, direction);
  std::vector<log::Log> logs;
  for (const SixLogs& directions : all) {
    logs.push_back(directions[direction]);
    logs.back().across = partner ? directions[*partner].displacement : std::vector<double>();
    for (double& force : logs.back().force) {
      force /= factor;
    }
    if (factor != 1.0) {
      logs.back().notes.push_back(fmt::format("forces divided by {:.6g}, the factor of stiffness_by_preload", factor));
    }
  }
  return logs;
}

DirectionDiagnosis diagnoseDirection(const io::ComponentDescription& component, Direction direction,
                                     const std::vector<log::Log>& logs, const std::vector<log::Log>& hold_out,
                                     DiagnosisOptions options) {
  options.turns = component::isRotation(direction);
  try {
    return {direction, diagnose(*component.six->directions[direction], logs, hold_out, options)};
  } catch (const log::LogError& error) {
    throw log::LogError(
        fmt::format("component '{}', direction {}: {}", component.name, toString(direction), error.what()));
  }
}

// Returns options that report the progress of one direction as part of the progress of all directions.
DiagnosisOptions shareOf(const DiagnosisOptions& options, Direction direction, std::size_t i, std::size_t count) {
  DiagnosisOptions share = options;
  if (options.progress) {
    share.progress = [=](const std::string& stage, double fraction) {
      options.progress(fmt::format("{}: {}", toString(direction), stage),
                       (static_cast<double>(i) + fraction) / static_cast<double>(count));
    };
  }
  return share;
}

// Copies the radial laws of a direction to its partner if the partner has none, because a radial law belongs to both.
void completeRadius(io::SixDirectionsDescription& six, Direction direction) {
  const std::optional<Direction> partner = partnerOf(six, direction);
  const auto elements = six.directions[direction]->allElements();
  if (partner && element::radialLaws(six.directions[*partner]->allElements()).empty()) {
    std::copy_if(elements.begin(), elements.end(), std::back_inserter(six.directions[*partner]->add),
                 element::isRadial);
  }
}

io::ComponentDescription augmentedOf(const io::ComponentDescription& component,
                                     const std::vector<DirectionDiagnosis>& directions) {
  auto six = std::make_shared<io::SixDirectionsDescription>(*component.six);
  for (const DirectionDiagnosis& found : directions) {
    if (hasComponentFile(found.diagnosis)) {
      six->directions[found.direction] = found.diagnosis.law.augmented;
    }
  }
  for (const DirectionDiagnosis& found : directions) {
    completeRadius(*six, found.direction);
  }
  io::ComponentDescription augmented = component;
  augmented.six = std::move(six);
  return augmented;
}

void subtractSimulated(const component::SixDirections& component, const log::PoseLog& log, SixLogs& measured) {
  const SixLogs simulated = gap::directionLogs(component, log, gap::replayPoses(component, log).wrench);
  for (std::size_t k = 0; k < component::kDirections; ++k) {
    for (std::size_t i = 0; i < log.size(); ++i) {
      measured[k].force[i] -= simulated[k].force[i];
    }
  }
}

}  // namespace

void requireDirections(const io::ComponentDescription& component, const std::vector<Direction>& directions) {
  if (!component.six) {
    throw std::invalid_argument("has one direction; accepted: no option --direction");
  }
  if (directions.empty()) {
    throw std::invalid_argument(fmt::format("has six directions; accepted: --direction with one or more of {}",
                                            acceptedDirections(*component.six)));
  }
  for (const Direction direction : directions) {
    requireDirection(*component.six, direction);
  }
}

SixDirectionsDiagnosis diagnoseDirections(const io::ComponentDescription& component,
                                          const std::vector<Direction>& directions,
                                          const std::vector<log::PoseLog>& logs,
                                          const std::vector<log::PoseLog>& hold_out, const DiagnosisOptions& options) {
  requireDirections(component, directions);
  const component::SixDirections configured = component.six->makeComponent();
  std::vector<SixLogs> measured = measuredDirections(configured, logs);
  const std::vector<SixLogs> unseen = measuredDirections(configured, hold_out);
  SixDirectionsDiagnosis result;
  result.component = component.name;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    result.directions.push_back(diagnoseDirection(
        component, directions[i], logsOf(measured, directions[i], *component.six),
        logsOf(unseen, directions[i], *component.six), shareOf(options, directions[i], i, directions.size())));
  }
  result.augmented = augmentedOf(component, result.directions);
  const component::SixDirections augmented = result.augmented.six->makeComponent();
  for (std::size_t i = 0; i < logs.size(); ++i) {
    subtractSimulated(augmented, logs[i], measured[i]);
  }
  for (const Direction of : directions) {
    for (std::size_t by = 0; by < component::kDirections; ++by) {
      if (by != of) {
        result.cross_map.push_back(results::crossShare(measured, of, static_cast<Direction>(by)));
      }
    }
  }
  return result;
}

}  // namespace rubber_suspension::diagnosis
