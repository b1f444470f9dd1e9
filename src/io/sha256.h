// SHA-256 of files and texts. The hash identifies the inputs of reports, and the inputs and jobs of campaigns.
#pragma once

#include <cstdint>
#include <string>

namespace rubber_suspension::io {

std::string sha256(const std::string& text);

struct FileHash {
  std::string sha256;      ///< 64 hexadecimal digits
  std::uint64_t size = 0;  ///< [bytes]
};

/// Returns the hash of a file, which is read piece by piece. Throws std::runtime_error, which begins with the path.
FileHash hashFile(const std::string& path);

}  // namespace rubber_suspension::io
