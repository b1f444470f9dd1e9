// Writes a file under a temporary name and renames it when it is complete.
#pragma once

#include <atomic>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace rubber_suspension::log {

/// Removes a file, or a folder of such files, if SIGINT, SIGTERM or SIGHUP ends the process while this object exists.
class RemovedBySignal {
 public:
  explicit RemovedBySignal(const std::string& path);
  RemovedBySignal(const RemovedBySignal&) = delete;
  RemovedBySignal& operator=(const RemovedBySignal&) = delete;
  ~RemovedBySignal();

 private:
  std::atomic<const std::string*>* slot_ = nullptr;  // null if all slots are in use, so that the file remains
};

/// Writes a file under a temporary name in the target's folder; commit() renames it to the target. The content is
/// written by line(), by write(), or by other code to writingPath(). Without commit() the temporary file is removed,
/// also if a signal ends the process, so that an existing target is never damaged. If the target is a symbolic link,
/// the file that it points to is replaced. Devices and pipes (/dev/stdout) are written directly. Several threads may
/// use objects of their own. All functions throw LogError that begins with the path.
class NewFile {
 public:
  /// Throws LogError also if the target exists and is not writable.
  explicit NewFile(const std::string& path);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  ~NewFile();

  /// Returns the path to write to: an empty file with the extension of the target, or a device or pipe.
  const std::string& writingPath() const { return writing_path_; }

  /// Appends a line. It is certain to be in the file only after commit().
  void line(std::string_view text);

  /// Writes the content and flushes the stream.
  void write(const std::string& content);

  /// Renames the file, which other writers must have closed. When this function returns, the file is on the disk.
  void commit();

 private:
  std::ofstream& stream();
  void requireStream() const;

  std::string path_;                        // the path as given, for errors
  std::string target_;                      // the path without symbolic links
  std::string writing_path_;                // path of the temporary file, or `path_` for a device or pipe
  std::optional<RemovedBySignal> removal_;  // exists as long as the temporary file
  std::ofstream stream_;
};

/// Returns true for paths that are written directly: devices, pipes, and all paths in /dev and /proc.
bool isStream(const std::string& path);

/// Returns the path without symbolic links. The last link may point to a file that does not exist.
std::string followedPath(const std::string& path);

/// Writes a whole file by means of NewFile. Throws LogError that begins with the path.
void writeNewFile(const std::string& path, const std::string& content);

}  // namespace rubber_suspension::log
