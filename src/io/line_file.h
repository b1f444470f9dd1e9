// A file of lines that takes its name when the last one is written.
#pragma once

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

#include "log/new_file.h"

namespace rubber_suspension::io {

class LineFile {
 public:
  explicit LineFile(const std::string& path)
      : path_(path), file_(path), stream_(file_.writingPath(), std::ios::binary) {}

  void line(const std::string& text) { stream_ << text << '\n'; }

  /// Throws std::runtime_error that begins with the path where a line could not be written.
  void close() {
    stream_.close();
    if (!stream_) {
      throw std::runtime_error(path_ + ": cannot be written: " + std::strerror(errno));
    }
    file_.commit();
  }

 private:
  std::string path_;
  log::NewFile file_;
  std::ofstream stream_;
};

}  // namespace rubber_suspension::io
