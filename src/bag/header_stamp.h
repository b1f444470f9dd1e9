// Stamps of logs as a ROS header can hold them.
#pragma once

#include <ros/time.h>

#include <cstdint>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::bag {

/// The time that shifts a log's stamps into those that a ROS header can hold (0 to 2^32 s); 0 where none is needed
/// [ns].
std::int64_t headerShift(const log::Log& log);

/// A stamp in [ns] as ROS time. Throws LogError where a header cannot hold it.
ros::Time toRosTime(std::int64_t stamp);

}  // namespace rubber_suspension::bag
