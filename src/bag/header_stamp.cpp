// Converts the stamps of logs to stamps of ROS headers.
#include "bag/header_stamp.h"

#include <fmt/format.h>

#include <limits>

namespace rubber_suspension::bag {

std::int64_t headerShift(const log::Log& log) {
  constexpr std::int64_t kOneSecond = 1000000000;
  constexpr std::int64_t kEnd = kOneSecond * std::numeric_limits<std::uint32_t>::max();
  const bool fits = log.stamp.empty() || (log.stamp.front() >= 0 && log.stamp.back() < kEnd);
  return fits ? 0 : kOneSecond - log.stamp.front();
}

ros::Time toRosTime(std::int64_t stamp) {
  ros::Time time;
  try {
    time.fromNSec(static_cast<std::uint64_t>(stamp));
  } catch (const std::runtime_error& error) {
    throw log::LogError(fmt::format("stamp {} ns: {}", stamp, error.what()));
  }
  return time;
}

}  // namespace rubber_suspension::bag
