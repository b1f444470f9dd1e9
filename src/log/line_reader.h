// Reads a text file line by line through a bounded buffer, for files of any size.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "log/byte_source.h"

namespace rubber_suspension::log {

class LineReader {
 public:
  LineReader(std::unique_ptr<ByteSource> source, std::size_t maximum_line);

  /// The next line, ended by a 0 in place of its line end (LF, CRLF, or CR in a file without LF), or nullptr at the end
  /// of the file; valid until the next call. Throws std::runtime_error for a line that is too long or holds a 0 byte,
  /// and where reading fails.
  char* next();

  std::size_t line() const { return line_; }     ///< number of the line last returned, from 1
  bool lastLineEnded() const { return ended_; }  ///< false where the file ends in the middle of a line

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
