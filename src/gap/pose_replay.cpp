// Simulates a component of six directions on the poses of a log.
#include "rubber_suspension/gap/pose_replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/progress.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::gap {
namespace {

[[noreturn]] void refusePose(const log::PoseLog& log, std::size_t sample, component::Acceptance acceptance) {
  const bool beyond = acceptance == component::Acceptance::beyond_measure;
  throw log::LogError(fmt::format(
      "{}: sample {}: rotation ({:g}, {:g}, {:g}) rad {}", log.name, sample + 1, log.coordinate[3][sample],
      log.coordinate[4][sample], log.coordinate[5][sample],
      beyond ? "is out of range; accepted: below 179 deg for a rotation vector, below 85 deg about y for cardan angles"
             : "gives a wrench that is not finite"));
}

Eigen::Vector3d vectorAt(const std::array<std::vector<double>, 6>& list, std::size_t first, std::size_t sample) {
  return {list[first][sample], list[first + 1][sample], list[first + 2][sample]};
}

// Returns true if the angles are within the range of the measure. Others would be converted to different angles.
bool holdsAt(const log::PoseLog& log, component::RotationMeasure measure, std::size_t sample) {
  return component::measureHolds(measure, vectorAt(log.coordinate, component::kRx, sample));
}

}  // namespace

Eigen::Quaterniond rotationAt(const log::PoseLog& log, component::RotationMeasure measure, std::size_t sample) {
  if (log.quaternion.empty()) {
    return component::rotationOf(measure, vectorAt(log.coordinate, component::kRx, sample));
  }
  const auto& [w, x, y, z] = log.quaternion[sample];
  return {w, x, y, z};
}

PoseReplay replayPoses(const component::SixDirections& component, const log::PoseLog& log) {
  component::PoseStream stream(component);
  io::Progress progress("simulating " + log.name, log.size());
  PoseReplay replay;
  for (std::vector<double>& column : replay.wrench) {
    column.resize(log.size());
  }
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (!log.temperature.empty() && !stream.setTemperature(log.temperature[i])) {
      throw log::LogError(fmt::format("{}: sample {}: temperature {:g} degC is out of range; accepted: {} degC",
                                      log.name, i + 1, log.temperature[i],
                                      element::describe(component.temperatures())));
    }
    const bool holds = holdsAt(log, component.laws().measure, i);
    const auto answer = stream.push(log.stamp[i], vectorAt(log.coordinate, component::kX, i),
                                    rotationAt(log, component.laws().measure, i));
    if (!holds || !component::isAccepted(answer.acceptance)) {
      refusePose(log, i, holds ? answer.acceptance : component::Acceptance::beyond_measure);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      replay.wrench[k][i] = answer.force.wrench.force[static_cast<Eigen::Index>(k)];
      replay.wrench[k + 3][i] = answer.force.wrench.moment[static_cast<Eigen::Index>(k)];
    }
    progress.advance(1);
  }
  replay.counters = stream.counters();
  replay.beyond_valid = stream.beyondValid();
  return replay;
}

std::array<log::Log, component::kDirections> directionLogs(const component::SixDirections& component,
                                                           const log::PoseLog& log,
                                                           const std::array<std::vector<double>, 6>& wrench) {
  std::array<log::Log, component::kDirections> logs;
  for (log::Log& direction : logs) {
    direction.name = log.name;
    direction.stamp = log.stamp;
    direction.temperature = log.temperature;
    direction.units = log.units;
    direction.counts = log.counts;
  }
  for (std::size_t i = 0; i < log.size(); ++i) {
    const Eigen::Isometry3d pose =
        component::poseOf(vectorAt(log.coordinate, component::kX, i), rotationAt(log, component.laws().measure, i));
    const component::SixNumbers coordinates = component.coordinates(pose);
    if (!holdsAt(log, component.laws().measure, i) || !component.holds(coordinates)) {
      refusePose(log, i, component::Acceptance::beyond_measure);
    }
    const component::SixNumbers forces =
        component.directionForces(pose, {vectorAt(wrench, component::kX, i), vectorAt(wrench, component::kRx, i)});
    for (std::size_t k = 0; k < component::kDirections; ++k) {
      logs[k].displacement.push_back(coordinates[static_cast<Eigen::Index>(k)]);
      logs[k].force.push_back(forces[static_cast<Eigen::Index>(k)]);
    }
  }
  return logs;
}

std::string summary(const std::string& component, const log::PoseLog& log, const PoseReplay& replay) {
  const auto largest = [&](std::size_t first) {
    double most = 0.0;
    for (std::size_t k = first; k < first + 3; ++k) {
      for (const double value : replay.wrench[k]) {
        most = std::max(most, std::abs(value));
      }
    }
    return most;
  };
  std::string text =
      fmt::format("{}: {} samples, {:.6g} s, forces up to {:.6g} N, moments up to {:.6g} N m", component, log.size(),
                  static_cast<double>(log.stamp.back() - log.stamp.front()) * 1e-9, largest(0), largest(3));
  for (std::size_t k = 0; k < log.wrench.size(); ++k) {
    const std::vector<double>& measured = log.wrench[k];
    if (!measured.empty() &&
        *std::min_element(measured.begin(), measured.end()) < *std::max_element(measured.begin(), measured.end())) {
      text += fmt::format(", gap in {} {:.4f}", component::toString(static_cast<component::Direction>(k)),
                          relativeGap(measured, replay.wrench[k], log.counts));
    }
  }
  return text;
}

}  // namespace rubber_suspension::gap
