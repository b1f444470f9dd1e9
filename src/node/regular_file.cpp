// Files that a parameter names: regular ones only.
#include "node/regular_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "log/new_file.h"

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

// A file descriptor that is closed at the end. To open a pipe without O_NONBLOCK would wait for its other end.
class File {
 public:
  explicit File(const std::string& path) : file_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOFOLLOW)) {
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

}  // namespace

void requireRegularFile(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) {
    fail(path, std::strerror(errno));
  }
  requireRegular(path, status);
}

std::string readRegularFile(const std::string& path, std::size_t most) {
  const File file(path);
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
  try {
    log::writeNewFile(path, text);
  } catch (const std::runtime_error& error) {
    throw FileError(error.what());
  }
}

}  // namespace rubber_suspension::node
