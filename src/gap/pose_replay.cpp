// Poses of a log through a component of six directions.
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
  throw log::LogError(
      fmt::format("{}: sample {}: rotation ({:g}, {:g}, {:g}) rad {}", log.name, sample + 1, log.coordinate[3][sample],
                  log.coordinate[4][sample], log.coordinate[5][sample],
                  beyond ? "is beyond the end of its measure; accepted: below 179 deg of a vector, 85 deg about y of "
                           "cardan angles"
                         : "gives a wrench that is not finite"));
}

}  // namespace

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
    const Eigen::Vector3d position(log.coordinate[0][i], log.coordinate[1][i], log.coordinate[2][i]);
    const Eigen::Vector3d turn(log.coordinate[3][i], log.coordinate[4][i], log.coordinate[5][i]);
    // As a topic has it; angles beyond the end of the measure would come back as others.
    const bool holds = component::measureHolds(component.laws().measure, turn);
    const auto answer = stream.push(log.stamp[i], position, component::rotationOf(component.laws().measure, turn));
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
                          relativeGap(measured, replay.wrench[k]));
    }
  }
  return text;
}

}  // namespace rubber_suspension::gap
