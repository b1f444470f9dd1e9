// Lock of a folder, into which only one run at a time may write.
#pragma once

#include <filesystem>
#include <optional>

#include "log/new_file.h"

namespace rubber_suspension::io {

/// Locks a folder for this process by means of an advisory lock (flock), which the system releases when the process
/// ends. Creates the folder if it is missing. Then the destructor, SIGINT, SIGTERM or SIGHUP removes it again if it is
/// empty.
class FolderLock {
 public:
  /// Throws OutputRefused if another process, or another object in this process, has locked the folder. Throws
  /// std::runtime_error if the folder cannot be created. On a file system without locks nothing is locked.
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
