// Converts the stamps of logs to stamps of ROS headers.
#pragma once

#include <ros/time.h>

#include <cstdint>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::bag {

/// Returns the time [ns] by which to shift the stamps of a log into the range of ROS headers (0 to 2^32 s), or 0.
std::int64_t headerShift(const log::Log& log);

/// Converts a stamp [ns] to ROS time. Throws LogError if it does not fit into a header.
ros::Time toRosTime(std::int64_t stamp);

}  // namespace rubber_suspension::bag
