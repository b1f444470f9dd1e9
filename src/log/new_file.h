// A file that is written beside the one that it replaces and takes its name when it is complete.
#pragma once

#include <atomic>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace rubber_suspension::log {

/// While it exists, a signal that ends the process (SIGINT, SIGTERM, SIGHUP) removes a file, or a folder that is empty
/// but for such files.
class RemovedBySignal {
 public:
  explicit RemovedBySignal(const std::string& path);
  RemovedBySignal(const RemovedBySignal&) = delete;
  RemovedBySignal& operator=(const RemovedBySignal&) = delete;
  ~RemovedBySignal();

 private:
  std::atomic<const std::string*>* slot_ = nullptr;  // nullptr: all were taken, and the signal leaves the file
};

/// The content goes to a file in the same folder, by line(), by write() or by whoever is given writingPath(); commit()
/// gives it the name wanted. Without commit() it is removed, also where a signal ends the process, so that an older
/// file of that name stays whole whatever happens. A symbolic link is followed: the file that it points to is replaced.
/// Other than regular files (/dev/stdout, a pipe) are written directly. Several threads may write files, each with its
/// own object. All calls throw LogError that begins with the path.
class NewFile {
 public:
  /// Throws also where an existing file may not be written.
  explicit NewFile(const std::string& path);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  ~NewFile();

  /// Where to write; it exists, empty, and ends in the extension of the path.
  const std::string& writingPath() const { return writing_path_; }

  /// Add a line, which may reach the file by commit() only.
  void line(std::string_view text);

  /// Write all of the content.
  void write(const std::string& content);

  /// Call when all is written and whoever else writes has closed the file; it is on the disk when this returns.
  void commit();

 private:
  std::ofstream& stream();
  void requireStream() const;

  std::string path_;                        // as given, for errors
  std::string target_;                      // without symbolic links
  std::string writing_path_;                // beside the target, or the path itself where that is no regular file
  std::optional<RemovedBySignal> removal_;  // while a file stands beside the target
  std::ofstream stream_;
};

/// True for what is written where it stands: devices and pipes, and /dev/stdout and the like, which lead to files that
/// are open already.
bool isStream(const std::string& path);

/// The path without symbolic links, also where the last of them points to a file that is not there.
std::string followedPath(const std::string& path);

/// Write a whole file so. Throws LogError that begins with the path.
void writeNewFile(const std::string& path, const std::string& content);

}  // namespace rubber_suspension::log
