// The SHA-256 of a file, by which a report names exactly what it read.
#pragma once

#include <string>

namespace rubber_suspension::io {

/// SHA-256 of the file's bytes in 64 hexadecimal digits, as sha256sum prints it. Throws std::runtime_error that begins
/// with the path.
std::string sha256OfFile(const std::string& path);

}  // namespace rubber_suspension::io
