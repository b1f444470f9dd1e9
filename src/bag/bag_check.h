// Checks the structure of a bag before it is read: rosbag's own reader trusts the index and crashes on a damaged one.
#pragma once

#include <string>

namespace rubber_suspension::bag {

/// Throws LogError where records do not fit into the file or their chunk, a header is damaged, an index entry points at
/// no message of its chunk, a connection is missing, the bag is encrypted, or it has no index.
/// Source of the format: http://wiki.ros.org/Bags/Format/2.0
void checkBagStructure(const std::string& path);

}  // namespace rubber_suspension::bag
