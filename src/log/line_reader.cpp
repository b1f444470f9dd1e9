// Reads a text file line by line through a bounded buffer.
#include "log/line_reader.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace rubber_suspension::log {

LineReader::LineReader(const std::string& path, std::size_t maximum_line)
    : file_(std::fopen(path.c_str(), "rb"), std::fclose), maximum_line_(maximum_line) {
  if (!file_) {
    throw std::runtime_error(std::strerror(errno));
  }
  buffer_.resize(2 * maximum_line + 1);
}

void LineReader::fill() {
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  end_ += std::fread(buffer_.data() + end_, 1, buffer_.size() - 1 - end_, file_.get());
  if (std::ferror(file_.get()) != 0) {
    throw std::runtime_error(std::strerror(errno));
  }
}

char* LineReader::next() {
  char* line_end = static_cast<char*>(std::memchr(buffer_.data() + begin_, '\n', end_ - begin_));
  if (line_end == nullptr) {
    fill();
    line_end = static_cast<char*>(std::memchr(buffer_.data(), '\n', end_));
  }
  if (begin_ == end_) {
    return nullptr;
  }
  ++line_;
  ended_ = line_end != nullptr;
  if (line_end == nullptr) {
    line_end = buffer_.data() + end_;
  }
  char* const line = buffer_.data() + begin_;
  const std::size_t length = static_cast<std::size_t>(line_end - line);
  if (length > maximum_line_) {
    throw std::runtime_error(fmt::format("line of more than {} bytes", maximum_line_));
  }
  if (std::memchr(line, '\0', length) != nullptr) {
    throw std::runtime_error("holds a 0 byte; accepted: text in UTF-8");
  }
  begin_ += length + (ended_ ? 1 : 0);
  *line_end = '\0';
  if (length > 0 && line_end[-1] == '\r') {
    line_end[-1] = '\0';
  }
  return line;
}

}  // namespace rubber_suspension::log
