// Small helpers on text and files that the readers share.
#include "log/text.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <memory>
#include <stdexcept>

namespace rubber_suspension::log {

namespace {

// The length of the character of UTF-8 that begins there; 0 where none does.
std::size_t characterLength(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(at);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xC0U) != 0x80U) {
      return 0;
    }
  }
  // Longer than needed, halves of UTF-16 pairs, beyond the last character.
  const unsigned second = byte(at + 1);
  const bool wrong = (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
                     (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
  return wrong ? 0 : length;
}

// Control characters beyond ASCII, and those that turn the direction of writing or cannot be seen (Unicode Cf, Zl, Zp).
bool isHarmful(const std::string& character) {
  static const char* const kLists[] = {"\u200B\u200C\u200D\u200E\u200F\u2028\u2029\u202A\u202B\u202C\u202D\u202E",
                                       "\u2060\u2066\u2067\u2068\u2069\uFEFF"};
  const bool control =
      character.size() == 2 && character[0] == '\xC2' && static_cast<unsigned char>(character[1]) < 0xA0;
  return control || (character.size() == 3 && std::any_of(std::begin(kLists), std::end(kLists), [&](const char* list) {
                       return std::strstr(list, character.c_str()) != nullptr;
                     }));
}

std::string escaped(const std::string& bytes) {
  std::string text;
  for (const unsigned char byte : bytes) {
    text += fmt::format("\\x{:02x}", byte);
  }
  return text;
}

}  // namespace

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

bool isUtf8(const std::string& text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t length = characterLength(text, at);
    if (length == 0) {
      return false;
    }
    at += length;
  }
  return true;
}

std::string toUtf8(const std::string& text) {
  if (isUtf8(text)) {
    return text;
  }
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      result += c;
    } else {
      result += static_cast<char>(0xC0U | (byte >> 6U));
      result += static_cast<char>(0x80U | (byte & 0x3FU));
    }
  }
  return result;
}

std::string oneLine(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = characterLength(text, at);
    const std::string character = text.substr(at, std::max<std::size_t>(length, 1));
    at += character.size();
    if (character.size() == 1 && std::strchr("\n\r\t", character[0]) != nullptr && character[0] != '\0') {
      result += ' ';
    } else {
      const bool control = character.size() == 1 && std::iscntrl(static_cast<unsigned char>(character[0])) != 0;
      result += length == 0 || control || isHarmful(character) ? escaped(character) : character;
    }
  }
  return result;
}

std::string quoted(const std::string& text) {
  constexpr std::size_t kLongest = 60;
  std::size_t end = std::min(kLongest, text.size());
  while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
    --end;  // a character is not cut in two
  }
  return fmt::format("'{}{}'", oneLine(text.substr(0, end)), end < text.size() ? "..." : "");
}

std::string join(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

void refuseNamedPipe(const std::string& path) {
  struct stat status {};
  // What a shell puts in the place of a command, <(...), is open already.
  const bool is_open = path.rfind("/dev/", 0) == 0 || path.rfind("/proc/", 0) == 0;
  if (!is_open && stat(path.c_str(), &status) == 0 && S_ISFIFO(status.st_mode)) {
    throw std::runtime_error("is a pipe; accepted: a regular file, or what a command writes, as <(COMMAND)");
  }
}

std::string readFile(const std::string& path, std::size_t maximum_size) {
  refuseNamedPipe(path);
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
