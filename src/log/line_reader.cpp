// Reads a text file line by line through a bounded buffer.
#include "log/line_reader.h"

#include <fmt/format.h>

#include <cstring>
#include <stdexcept>
#include <utility>

namespace rubber_suspension::log {

LineReader::LineReader(std::unique_ptr<ByteSource> source, std::size_t maximum_line)
    : source_(std::move(source)), maximum_line_(maximum_line), buffer_(2 * maximum_line + 1) {
  fill();
  findLineEnd();
}

void LineReader::fill() {
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  std::size_t count = 1;
  while (count > 0 && end_ < buffer_.size() - 1) {
    count = source_->read(buffer_.data() + end_, buffer_.size() - 1 - end_);
    end_ += count;
  }
}

void LineReader::findLineEnd() {
  const auto holds = [&](char c) { return std::memchr(buffer_.data(), c, end_) != nullptr; };
  line_end_ = !holds('\n') && holds('\r') ? '\r' : '\n';
}

char* LineReader::next() {
  char* line_end = static_cast<char*>(std::memchr(buffer_.data() + begin_, line_end_, end_ - begin_));
  if (line_end == nullptr) {
    fill();
    line_end = static_cast<char*>(std::memchr(buffer_.data(), line_end_, end_));
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
    throw std::runtime_error("holds a 0 byte; accepted: text in UTF-8, UTF-16 or Latin-1");
  }
  begin_ += length + (ended_ ? 1 : 0);
  *line_end = '\0';
  while (line_end > line && line_end[-1] == '\r') {
    *--line_end = '\0';
  }
  return line;
}

}  // namespace rubber_suspension::log
