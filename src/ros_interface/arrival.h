// How long ago a message arrived.
#pragma once

#include <ros/time.h>

#include <chrono>
#include <cstdint>

namespace rubber_suspension::ros_interface {

/// From arrival to now [ns]. ROS stamps arrivals with ros::Time, which stands for real time only while no simulated
/// time is in use; then what is known is the time since `callback`, when the message's callback began.
std::int64_t timeSinceArrival(const ros::Time& receipt, std::chrono::steady_clock::time_point callback);

}  // namespace rubber_suspension::ros_interface
