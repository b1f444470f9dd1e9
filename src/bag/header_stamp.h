// Conversion of the stamps of logs to those of ROS headers.
#pragma once

#include <ros/time.h>

#include <cstdint>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::bag {

/// Returns the time [ns] that shifts a log's stamps into those of a ROS header (0 to 2^32 s); 0 if none is needed.
std::int64_t headerShift(const log::Log& log);

/// Returns a stamp [ns] as ROS time. Throws LogError if a header cannot hold it.
ros::Time toRosTime(std::int64_t stamp);

}  // namespace rubber_suspension::bag
