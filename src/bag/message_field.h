// One number of every message on a topic, by the definition of the message that the bag holds.
#pragma once

#include <rosbag/bag.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace rubber_suspension::bag {

/// Values over time.
struct Series {
  std::vector<std::int64_t> stamp;    // [ns]
  std::vector<std::int64_t> receipt;  // [ns]
  std::vector<double> value;
};

/// The numbers that "/topic/field.field" or "/topic.field[2].field" names, in the bag of that path:
/// "/ft/wrench.force.z",
/// "/joint_states/position[knee]", where the name is one of the message's `name`. The first field may be left out where
/// one alone has the next, and `data` where the topic is all. Stamps are those of the header, or the times of receipt
/// where there is none. Throws LogError that names what there is.
Series readField(const rosbag::Bag& bag, const std::string& path, const std::string& field);

}  // namespace rubber_suspension::bag
