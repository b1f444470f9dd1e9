// Files that parameters name. They must be regular, so that no device, pipe or endless stream is read or replaced.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace rubber_suspension::node {

/// Thrown if a file cannot be read or written. what() is one line with file and reason.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws FileError unless the path leads to a regular file, directly or through a link.
void requireRegularFile(const std::string& path);

/// Returns the content of a regular file of at most `most` bytes. Throws FileError, also for a symbolic link.
std::string readRegularFile(const std::string& path, std::size_t most);

/// Writes a regular file atomically, even if the power fails. Throws FileError, also for a symbolic link.
void replaceRegularFile(const std::string& path, const std::string& text);

}  // namespace rubber_suspension::node
