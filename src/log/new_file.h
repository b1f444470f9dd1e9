// A file that is written under a temporary name and renamed when it is complete.
#pragma once

#include <atomic>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace rubber_suspension::log {

/// Removes a file, or a folder that contains only such files, if a signal (SIGINT, SIGTERM, SIGHUP) ends the process
/// during the lifetime of the object.
class RemovedBySignal {
 public:
  explicit RemovedBySignal(const std::string& path);
  RemovedBySignal(const RemovedBySignal&) = delete;
  RemovedBySignal& operator=(const RemovedBySignal&) = delete;
  ~RemovedBySignal();

 private:
  std::atomic<const std::string*>* slot_ = nullptr;  // nullptr: no slot was free, and the file remains
};

/// Writes a file under a temporary name in the same folder, by line(), by write() or by others to writingPath();
/// commit() renames it. Without commit() it is removed, also if a signal ends the process, so that an older file of
/// that name is never damaged. A symbolic link is followed: the file that it points to is replaced. Devices and pipes
/// (/dev/stdout) are written directly. Several threads may write files, each with its own object. All calls throw
/// LogError that begins with the path.
class NewFile {
 public:
  /// Throws also if an existing file is not writable.
  explicit NewFile(const std::string& path);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  ~NewFile();

  /// Returns the path to write to: an empty file with the extension of the final path, or a device or pipe.
  const std::string& writingPath() const { return writing_path_; }

  /// Adds a line, which may reach the file by commit() only.
  void line(std::string_view text);

  /// Writes the content and flushes it.
  void write(const std::string& content);

  /// Renames the file, once all other writers have closed it; it is on the disk when this returns.
  void commit();

 private:
  std::ofstream& stream();
  void requireStream() const;

  std::string path_;                        // as given, for errors
  std::string target_;                      // without symbolic links
  std::string writing_path_;                // beside the target, or the path itself if that is a device or pipe
  std::optional<RemovedBySignal> removal_;  // while the temporary file exists
  std::ofstream stream_;
};

/// Returns true for paths that are written directly: devices and pipes, and /dev/stdout and the like, which refer to
/// files that are open already.
bool isStream(const std::string& path);

/// Returns the path without symbolic links, also if the last one points to a file that does not exist.
std::string followedPath(const std::string& path);

/// Writes a whole file as NewFile does. Throws LogError that begins with the path.
void writeNewFile(const std::string& path, const std::string& content);

}  // namespace rubber_suspension::log
