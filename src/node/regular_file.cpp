// Files that parameters name. They must be regular files.
#include "node/regular_file.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "log/new_file.h"

namespace rubber_suspension::node {
namespace {

using Type = std::filesystem::file_type;

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw FileError(fmt::format("{}: {}", path, reason));
}

void requireRegular(const std::string& path, Type type) {
  const std::string kind = type == Type::directory ? "a folder"
                           : type == Type::fifo    ? "a pipe"
                           : type == Type::socket  ? "a socket"
                           : type == Type::symlink ? "a symbolic link"
                                                   : "a device";
  if (type != Type::regular) {
    fail(path, type == Type::not_found ? std::strerror(ENOENT) : "is " + kind + "; accepted: a regular file");
  }
}

// Returns the type of the file at `seen`, which is `path` or another path to the same file. Errors contain `path`.
Type typeOf(const std::string& path, const std::string& seen) {
  std::error_code error;
  const Type type = status(std::filesystem::path(seen), error).type();
  if (type == Type::none) {
    fail(path, error.message());
  }
  return type;
}

}  // namespace

void requireRegularFile(const std::string& path) { requireRegular(path, typeOf(path, path)); }

std::string readRegularFile(const std::string& path, std::size_t most) {
  // Without O_NONBLOCK, opening a pipe would wait for a writer.
  const int opened = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOFOLLOW);
  if (opened < 0) {
    fail(path, errno == ELOOP ? "is a symbolic link; accepted: a regular file" : std::strerror(errno));
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(fdopen(opened, "rb"), std::fclose);
  requireRegular(path, typeOf(path, fmt::format("/proc/self/fd/{}", opened)));
  std::string text;
  std::array<char, 65536> piece{};
  for (std::size_t size = 1; size > 0 && text.size() <= most; text.append(piece.data(), size)) {
    size = std::fread(piece.data(), 1, piece.size(), file.get());
  }
  if (std::ferror(file.get()) != 0) {
    fail(path, std::strerror(errno));
  }
  if (text.size() > most) {
    fail(path, fmt::format("the file is too large; accepted: at most {} bytes", most));
  }
  return text;
}

void replaceRegularFile(const std::string& path, const std::string& text) {
  std::error_code unknown;  // an error is reported when writing fails
  const Type type = symlink_status(std::filesystem::path(path), unknown).type();
  if (type != Type::not_found && type != Type::none) {
    requireRegular(path, type);
  }
  try {
    log::writeNewFile(path, text);
  } catch (const std::runtime_error& error) {
    throw FileError(error.what());
  }
}

}  // namespace rubber_suspension::node
