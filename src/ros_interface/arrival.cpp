// How long ago a message arrived.
#include "ros_interface/arrival.h"

#include <algorithm>

namespace rubber_suspension::ros_interface {

std::int64_t timeSinceArrival(const ros::Time& receipt, std::chrono::steady_clock::time_point callback) {
  if (ros::Time::isSystemTime()) {
    return std::max<std::int64_t>(0, (ros::Time::now() - receipt).toNSec());
  }
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now() - callback).count();
}

}  // namespace rubber_suspension::ros_interface
