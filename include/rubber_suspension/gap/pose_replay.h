// Simulates a component of six directions on a recorded log, offline.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "rubber_suspension/component/pose_stream.h"
#include "rubber_suspension/log/pose_log.h"

namespace rubber_suspension::gap {

/// The rotation of a sample, as a topic has it.
Eigen::Quaterniond rotationAt(const log::PoseLog& log, component::RotationMeasure measure, std::size_t sample);

/// The result of a simulation of a log.
struct PoseReplay {
  std::array<std::vector<double>, 6> wrench;  ///< [N, N m], one of each per sample
  component::StreamCounters counters;
  std::uint64_t beyond_valid = 0;  ///< samples beyond the stated validity of the rotation
};

/// The wrench at every sample of a log, by the same stream that the node feeds. Shows progress on a terminal. Throws
/// LogError, with the sample, where the rotation is beyond the end of its measure, a wrench is not finite, or a
/// temperature is none at which the component's shift holds.
PoseReplay replayPoses(const component::SixDirections& component, const log::PoseLog& log);

/// Each direction as a log of its own: the coordinates [m, rad] of the bush, and the generalised forces [N, N m] that a
/// wrench on B at the log's poses amounts to. Throws LogError as replayPoses() does of rotations.
std::array<log::Log, component::kDirections> directionLogs(const component::SixDirections& component,
                                                           const log::PoseLog& log,
                                                           const std::array<std::vector<double>, 6>& wrench);

/// One line for the terminal: samples, duration, the largest force and moment and, with measured wrenches, the gap of
/// each direction that moved a load.
std::string summary(const std::string& component, const log::PoseLog& log, const PoseReplay& replay);

}  // namespace rubber_suspension::gap
