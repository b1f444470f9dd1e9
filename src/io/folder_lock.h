// A folder that one run at a time writes into.
#pragma once

#include <filesystem>
#include <optional>

#include "log/new_file.h"

namespace rubber_suspension::io {

/// Holds a folder for this process, by an advisory lock on the folder itself (flock), which ends with the process
/// however that ends. The folder is made where it is missing, and removed again where nothing has come into it, by
/// whatever signal the process is ended.
class FolderLock {
 public:
  /// Throws OutputRefused where another process, or another lock of this one, holds the folder; std::runtime_error
  /// where it cannot be made. On a file system that knows no locks nothing is held.
  explicit FolderLock(std::filesystem::path folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::filesystem::path folder_;
  bool made_ = false;
  std::optional<log::RemovedBySignal> removal_;
  int descriptor_ = -1;
};

}  // namespace rubber_suspension::io
