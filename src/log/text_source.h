// Reads a log as text in UTF-8, whatever the file is (plain, gzip, UTF-16), and its lines.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace rubber_suspension::log {

/// A stream of bytes. Throws std::runtime_error with the reason if it cannot be read.
class ByteSource {
 public:
  ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  virtual ~ByteSource() = default;

  /// Reads up to `size` bytes and returns their number; 0 at the end only.
  virtual std::size_t read(char* to, std::size_t size) = 0;
};

/// The text of a log and what it was made from.
struct TextSource {
  std::unique_ptr<ByteSource> bytes;  ///< without byte order mark; UTF-8, or perhaps Latin-1 if the file has no mark
  std::string coding;                 ///< "", "UTF-16", "gzip", "gzip, UTF-16"
};

/// Opens a log as text. The file is read once, from its start, so that it may be a pipe. Throws std::runtime_error with
/// the system's reason, or for a known format other than text, with its name and how to convert it. `large`: gzip may
/// expand to more than refuseUnpacked() accepts.
TextSource openText(const std::string& path, bool large = false);

/// Reads a whole text of at most `maximum_size` bytes. Throws as openText() does, and for more bytes.
std::string readText(const std::string& path, std::size_t maximum_size);

/// Reads text line by line through a bounded buffer, for files of any size.
class LineReader {
 public:
  LineReader(std::unique_ptr<ByteSource> source, std::size_t maximum_line);

  /// Returns the next line, ended by a 0 in place of its line end (LF, CRLF, or CR in a file without LF), or nullptr at
  /// the end of the file; valid until the next call. Throws std::runtime_error for a line that is too long or contains
  /// a 0 byte, and if reading fails.
  char* next();

  std::size_t line() const { return line_; }     ///< number of the line last returned, from 1
  bool lastLineEnded() const { return ended_; }  ///< false if the file ends in the middle of a line

 private:
  void fill();
  void findLineEnd();

  std::unique_ptr<ByteSource> source_;
  std::size_t maximum_line_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::size_t line_ = 0;
  char line_end_ = '\n';
  bool ended_ = true;
};

}  // namespace rubber_suspension::log
