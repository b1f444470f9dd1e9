// Reads one number of every message on a topic, by the definition of the message in the bag.
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

/// Reads the numbers of a field "/topic/field.field" or "/topic.field[2].field", as in "/ft/wrench.force.z" and
/// "/joint_states/position[knee]", where knee is one of the entries of the message's field `name`. The first field may
/// be omitted if only one contains the next; a topic alone stands for its field `data`. Stamps are those of the header,
/// or the times of receipt if there is none. `path`: of the bag, for errors. Throws LogError that names the topics or
/// fields there are.
Series readField(const rosbag::Bag& bag, const std::string& path, const std::string& field);

}  // namespace rubber_suspension::bag
