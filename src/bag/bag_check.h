// Checks the structure of a bag before rosbag reads it, because rosbag crashes on a damaged index.
#pragma once

#include <string>

namespace rubber_suspension::bag {

/// Throws LogError if a record does not fit into the file or its chunk, a header is damaged, an index entry does not
/// point to a message of its chunk, the record of a connection is missing, or the bag is encrypted or has no index.
/// Source of the format: http://wiki.ros.org/Bags/Format/2.0
void checkBagStructure(const std::string& path);

}  // namespace rubber_suspension::bag
