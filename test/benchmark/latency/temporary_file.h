// Files that what is measured reads.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "log/new_file.h"

namespace rubber_suspension::benchmark {

/// A file with this text that goes with this object, one of each name. Throws std::runtime_error where it cannot be
/// written.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& text, const std::string& name)
      : path_(std::filesystem::temp_directory_path() / fmt::format("rubber_suspension_{}_{}", getpid(), name)) {
    log::writeNewFile(path_, text);
  }
  ~TemporaryFile() { std::remove(path_.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace rubber_suspension::benchmark
