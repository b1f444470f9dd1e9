// Simulates a component of six directions on a recorded log, offline.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "rubber_suspension/component/pose_stream.h"
#include "rubber_suspension/log/pose_log.h"

namespace rubber_suspension::gap {

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

/// One line for the terminal: samples, duration, the largest force and moment and, with measured wrenches, the gap of
/// each direction that moved a load.
std::string summary(const std::string& component, const log::PoseLog& log, const PoseReplay& replay);

}  // namespace rubber_suspension::gap
