// Zip archives in memory.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::fmi {

/// A file in an archive: its path, with slashes, and its content.
struct ArchiveEntry {
  std::string path;
  std::string content;
};

/// The bytes of a zip archive; the same for the same entries. Throws std::runtime_error.
std::string toZip(const std::vector<ArchiveEntry>& entries);

}  // namespace rubber_suspension::fmi
