// Reads a text file line by line through a bounded buffer, for files of any size.
#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace rubber_suspension::log {

class LineReader {
 public:
  /// Throws std::runtime_error with the system's reason where the file cannot be opened.
  LineReader(const std::string& path, std::size_t maximum_line);

  /// The next line, ended by a 0 in place of its line end (LF or CRLF), or nullptr at the end of the file; valid until
  /// the next call. Throws std::runtime_error for a line that is too long or holds a 0 byte, and where reading fails.
  char* next();

  std::size_t line() const { return line_; }     ///< number of the line last returned, from 1
  bool lastLineEnded() const { return ended_; }  ///< false where the file ends in the middle of a line

 private:
  void fill();

  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::size_t maximum_line_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::size_t line_ = 0;
  bool ended_ = true;
};

}  // namespace rubber_suspension::log
