// Reads a plain, gzip or UTF-16 file as text in UTF-8, whole or line by line.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace rubber_suspension::log {

/// A stream of bytes. read() throws std::runtime_error with the reason if reading fails.
class ByteSource {
 public:
  ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  virtual ~ByteSource() = default;

  /// Reads up to `size` bytes and returns their number, which is 0 only at the end of the stream.
  virtual std::size_t read(char* to, std::size_t size) = 0;
};

/// The text of a file, and how the file encodes it.
struct TextSource {
  std::unique_ptr<ByteSource> bytes;  ///< UTF-8 or Latin-1, without byte order mark
  std::string coding;                 ///< "", "UTF-16", "gzip" or "gzip, UTF-16"
};

/// Opens a file as text. The file is read once from its start, so it may be a pipe. Throws std::runtime_error with the
/// reason of the system, or for a known format other than text with its name and a way to convert it. If `large` is
/// true, gzip may expand beyond the limit of refuseUnpacked().
TextSource openText(const std::string& path, bool large = false);

/// Returns the whole text. Throws as openText() does, and for a text of more than `maximum_size` bytes.
std::string readText(const std::string& path, std::size_t maximum_size);

/// Reads text line by line through a buffer of fixed size, for files of any size.
class LineReader {
 public:
  LineReader(std::unique_ptr<ByteSource> source, std::size_t maximum_line);

  /// Returns the next line, or nullptr at the end of the file. The line end (LF, CRLF, or CR in a file without LF) is
  /// replaced by a null character. The line is valid until the next call. Throws std::runtime_error if reading fails or
  /// a line is too long or contains a null character.
  char* next();

  std::size_t line() const { return line_; }     ///< number of the line that was returned last, counted from 1
  bool lastLineEnded() const { return ended_; }  ///< false if the file ends without a line end

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
