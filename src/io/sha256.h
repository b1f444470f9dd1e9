// SHA-256 of files and texts, by which a report names what it read and a campaign knows its inputs and jobs again.
#pragma once

#include <cstdint>
#include <string>

namespace rubber_suspension::io {

/// The hash as 64 hexadecimal digits.
std::string sha256(const std::string& text);

struct FileHash {
  std::string sha256;      ///< 64 hexadecimal digits
  std::uint64_t size = 0;  ///< [bytes]
};

/// Hashes a file, read piece by piece. Throws std::runtime_error that begins with the path.
FileHash hashFile(const std::string& path);

}  // namespace rubber_suspension::io
