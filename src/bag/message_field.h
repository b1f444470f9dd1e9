// Reads one number from every message on a topic, according to the definition of the message in the bag.
#pragma once

#include <rosbag/bag.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace rubber_suspension::bag {

/// Values with their times.
struct Series {
  std::vector<std::int64_t> stamp;    // [ns]
  std::vector<std::int64_t> receipt;  // [ns]
  std::vector<double> value;
};

/// Reads the numbers of a field from a topic. The field is written "/topic/field.field" or "/topic.field[2].field", as
/// in "/ft/wrench.force.z". In "/joint_states/position[knee]", knee is an entry of the message's field `name`. The
/// first field may be omitted if only one field contains the second; a topic alone selects its field `data`. Stamps are
/// those of the header, or else the times of receipt. `path` is for errors. Throws LogError.
Series readField(const rosbag::Bag& bag, const std::string& path, const std::string& field);

}  // namespace rubber_suspension::bag
