// The bytes of a log as text in UTF-8, whatever the file is: plain, gzip, UTF-16.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace rubber_suspension::log {

/// Bytes one after the other. Throws std::runtime_error with the reason where they cannot be read.
class ByteSource {
 public:
  ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  virtual ~ByteSource() = default;

  /// Up to `size` bytes; 0 at the end only.
  virtual std::size_t read(char* to, std::size_t size) = 0;
};

/// The text of a log and what it was made from.
struct TextSource {
  std::unique_ptr<ByteSource> bytes;  ///< without byte order mark; UTF-8, or Latin-1 where no byte order mark tells it
  std::string coding;                 ///< "", "UTF-16", "gzip", "gzip, UTF-16"
};

/// Open a log as text; the file is read once, from its start, so that it may be a pipe.
/// Throws std::runtime_error with the system's reason, and where the content is known to be another format than text:
/// its name and what makes a readable file of it.
TextSource openText(const std::string& path);

}  // namespace rubber_suspension::log
