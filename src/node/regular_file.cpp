// Files that a parameter names: regular ones only.
#include "node/regular_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace rubber_suspension::node {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw FileError(fmt::format("{}: {}", path, reason));
}

[[noreturn]] void failWithErrno(const std::string& path) {
  fail(path, errno == ELOOP ? "is a symbolic link; accepted: a regular file" : std::strerror(errno));
}

std::string kindOf(mode_t mode) {
  switch (mode & static_cast<mode_t>(S_IFMT)) {
    case S_IFDIR:
      return "a folder";
    case S_IFIFO:
      return "a pipe";
    case S_IFSOCK:
      return "a socket";
    case S_IFLNK:
      return "a symbolic link";
    default:
      return "a device";
  }
}

void requireRegular(const std::string& path, const struct stat& status) {
  if (!S_ISREG(status.st_mode)) {
    fail(path, fmt::format("is {}; accepted: a regular file", kindOf(status.st_mode)));
  }
}

// A file descriptor that is closed at the end.
class File {
 public:
  File(const std::string& path, int flags) : file_(open(path.c_str(), flags | O_CLOEXEC | O_NOFOLLOW, 0644)) {
    if (file_ < 0) {
      failWithErrno(path);
    }
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() { close(file_); }

  int get() const { return file_; }

 private:
  int file_;
};

void writeAll(const File& file, const std::string& path, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t written = write(file.get(), text.data() + done, text.size() - done);
    if (written < 0 && errno != EINTR) {
      failWithErrno(path);
    }
    done += static_cast<std::size_t>(std::max<ssize_t>(written, 0));
  }
  if (fsync(file.get()) != 0) {
    failWithErrno(path);
  }
}

// So that the file has its new name after a power failure, too.
void syncFolderOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  const int file = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file >= 0) {
    fsync(file);
    close(file);
  }
}

}  // namespace

void requireRegularFile(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) {
    fail(path, std::strerror(errno));
  }
  requireRegular(path, status);
}

std::string readRegularFile(const std::string& path, std::size_t most) {
  const File file(path, O_RDONLY | O_NONBLOCK);  // to open a pipe would wait for its other end
  struct stat status {};
  if (fstat(file.get(), &status) != 0) {
    failWithErrno(path);
  }
  requireRegular(path, status);
  std::string text;
  std::array<char, 65536> piece{};
  while (text.size() <= most) {
    const ssize_t size = read(file.get(), piece.data(), piece.size());
    if (size < 0 && errno != EINTR) {
      failWithErrno(path);
    }
    if (size == 0) {
      return text;
    }
    text.append(piece.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  }
  fail(path, fmt::format("larger than {} bytes", most));
}

void replaceRegularFile(const std::string& path, const std::string& text) {
  struct stat status {};
  if (lstat(path.c_str(), &status) == 0) {
    requireRegular(path, status);
  }
  const std::string next = path + ".next";
  if (lstat(next.c_str(), &status) == 0) {
    requireRegular(next, status);
    unlink(next.c_str());  // left by a process that was killed while it wrote
  }
  try {
    const File file(next, O_WRONLY | O_CREAT | O_EXCL);
    writeAll(file, next, text);
  } catch (const FileError&) {
    unlink(next.c_str());
    throw;
  }
  if (std::rename(next.c_str(), path.c_str()) != 0) {
    failWithErrno(path);
  }
  syncFolderOf(path);
}

}  // namespace rubber_suspension::node
