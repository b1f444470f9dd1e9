// Simulates a component of six directions on a recorded log, offline.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "rubber_suspension/component/pose_stream.h"
#include "rubber_suspension/log/pose_log.h"

namespace rubber_suspension::gap {

/// Returns the rotation of a sample, as a topic contains it.
Eigen::Quaterniond rotationAt(const log::PoseLog& log, component::RotationMeasure measure, std::size_t sample);

/// The result of a simulation of a log.
struct PoseReplay {
  std::array<std::vector<double>, 6> wrench;  ///< [N, N m], one of each per sample
  component::StreamCounters counters;
  std::uint64_t beyond_valid = 0;  ///< samples beyond the stated validity of the rotation
};

/// Returns the wrench at every sample of a log, by the same stream that the node feeds. Shows progress on a terminal.
/// Throws LogError, with the sample, if a rotation is beyond the range of its measure, a wrench is not finite, or a
/// temperature is outside the range of the component's shift.
PoseReplay replayPoses(const component::SixDirections& component, const log::PoseLog& log);

/// Returns each direction as a separate log: the coordinates [m, rad] of the bush, and the generalised forces [N, N m]
/// that are equivalent to a wrench on B at the log's poses. Throws LogError for rotations, as replayPoses() does.
std::array<log::Log, component::kDirections> directionLogs(const component::SixDirections& component,
                                                           const log::PoseLog& log,
                                                           const std::array<std::vector<double>, 6>& wrench);

/// Returns one line for the terminal: samples, duration, the largest force and moment and, with measured wrenches, the
/// gap of each direction that has a varying load.
std::string summary(const std::string& component, const log::PoseLog& log, const PoseReplay& replay);

}  // namespace rubber_suspension::gap
