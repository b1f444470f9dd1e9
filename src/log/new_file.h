// A file that is written beside the one that it replaces and takes its name when it is complete.
#pragma once

#include <stdexcept>
#include <string>

namespace rubber_suspension::log {

/// Text goes to writingPath(), in the same folder; commit() gives it the name wanted. Without commit() it is
/// removed, also where a signal ends the process (SIGINT, SIGTERM, SIGHUP), so that an older file of that name stays
/// whole whatever happens. A symbolic link is followed: the file that it points to is replaced. What is no regular file
/// (/dev/stdout, a pipe) is written at once.
/// Several threads may write files at once, each with an object of its own.
class NewFile {
 public:
  /// Throws std::runtime_error that begins with the path, also where an existing file may not be written.
  explicit NewFile(const std::string& path);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  ~NewFile();

  /// Where to write; it exists, empty, and ends in the extension of the path.
  const std::string& writingPath() const { return writing_path_; }

  /// Write all of it. Throws std::runtime_error.
  void write(const std::string& content) const;

  /// Call when all is written and the file is closed; it is on the disk when this returns. Throws std::runtime_error.
  void commit();

 private:
  void createBeside(int permissions);
  void discard();

  std::string path_;          // as given, for errors
  std::string target_;        // without symbolic links
  std::string writing_path_;  // beside the target, or the path itself where that is no regular file
  int slot_ = -1;             // in the list of files that a signal removes; -1: none
};

/// A folder that a signal which ends the process removes, where it is empty but for unfinished files.
class RemovedBySignal {
 public:
  explicit RemovedBySignal(const std::string& folder);
  RemovedBySignal(const RemovedBySignal&) = delete;
  RemovedBySignal& operator=(const RemovedBySignal&) = delete;
  ~RemovedBySignal();

 private:
  int slot_;
};

/// True for what is written where it stands: devices and pipes, and /dev/stdout and the like, which lead to files that
/// are open already.
bool isStream(const std::string& path);

/// The path without symbolic links, also where the last of them points to a file that is not there.
std::string followedPath(const std::string& path);

/// Write a whole file so. Throws std::runtime_error that begins with the path.
void writeNewFile(const std::string& path, const std::string& content);

}  // namespace rubber_suspension::log
