// Simulates a component of six directions on a recorded log.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "rubber_suspension/component/pose_stream.h"
#include "rubber_suspension/log/pose_log.h"

namespace rubber_suspension::gap {

/// Returns the rotation of a sample as a quaternion, whichever way the log states it.
Eigen::Quaterniond rotationAt(const log::PoseLog& log, component::RotationMeasure measure, std::size_t sample);

struct PoseReplay {
  std::array<std::vector<double>, 6> wrench;  ///< forces [N] and moments [N m], one value per sample
  component::StreamCounters counters;
  std::uint64_t beyond_valid = 0;  ///< number of samples beyond the stated validity of the rotation
};

/// Returns the wrench at every sample of a log, computed by the same stream as in the node. Shows progress on a
/// terminal. Throws LogError with the number of the sample if a rotation is beyond the range of its measure, a wrench
/// is not finite, or a temperature is outside the range of the component's shift.
PoseReplay replayPoses(const component::SixDirections& component, const log::PoseLog& log);

/// Returns each direction as a separate log. Displacements are the coordinates of the bush [m, rad]; forces are the
/// generalised forces [N, N m] that are equivalent to a wrench on B at the poses of the log. Throws LogError for
/// rotations, as replayPoses() does.
std::array<log::Log, component::kDirections> directionLogs(const component::SixDirections& component,
                                                           const log::PoseLog& log,
                                                           const std::array<std::vector<double>, 6>& wrench);

/// Returns one line for the terminal: samples, duration, and the largest force and moment. If wrenches were measured,
/// it also states the gap of each direction whose load varies.
std::string summary(const std::string& component, const log::PoseLog& log, const PoseReplay& replay);

}  // namespace rubber_suspension::gap
