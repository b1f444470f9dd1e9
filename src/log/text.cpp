// Small helpers on text and files that the readers share.
#include "log/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace rubber_suspension::log {

std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return text;
}

std::string quoted(const std::string& text) {
  constexpr std::size_t kLongest = 60;
  return fmt::format("'{}{}'", oneLine(text.substr(0, kLongest)), text.size() > kLongest ? "..." : "");
}

std::string join(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

std::string readFile(const std::string& path, std::size_t maximum_size) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) {
    throw std::runtime_error(std::strerror(errno));
  }
  std::string text(maximum_size + 1, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file.get()));
  if (std::ferror(file.get()) != 0) {
    throw std::runtime_error(std::strerror(errno));
  }
  if (text.size() > maximum_size) {
    throw std::runtime_error(fmt::format("more than {} bytes; accepted: that many at most", maximum_size));
  }
  return text;
}

}  // namespace rubber_suspension::log
