// Checks the structure of a bag before it is read: rosbag's own reader trusts the index and crashes on a damaged one.
#pragma once

#include <string>

namespace rubber_suspension {

/// Throws LogError where records do not fit into the file, an index entry points at no message of its chunk, or a
/// connection is missing. Of a compressed chunk the entries are held to its size only: what lies inside is guarded by
/// the compression's own checksums.
/// Source of the format: http://wiki.ros.org/Bags/Format/2.0
void checkBagStructure(const std::string& path);

}  // namespace rubber_suspension
