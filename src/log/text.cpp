// Functions on text and files that the readers share.
#include "log/text.h"

#include <fmt/format.h>
#include <iconv.h>
#include <sys/stat.h>

#include <algorithm>
#include <boost/locale/utf.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "element/refuse.h"

namespace rubber_suspension::log {

namespace {

using Utf8 = boost::locale::utf::utf_traits<char>;
using boost::locale::utf::code_point;

// Returns the UTF-8 character at `at` and advances `at` past it. Returns nullopt for an invalid byte.
std::optional<code_point> takeCharacter(const char*& at, const char* end) {
  const char* next = at;
  const code_point character = Utf8::decode(next, end);
  const bool valid = character != boost::locale::utf::illegal && character != boost::locale::utf::incomplete;
  at = valid ? next : at + 1;
  return valid ? std::optional(character) : std::nullopt;
}

// Returns true for control characters, and for characters that change the direction of writing or are invisible.
bool isHarmful(code_point character) {
  constexpr std::pair<code_point, code_point> kRanges[] = {{0x00, 0x1F},     {0x7F, 0x9F},     {0x200B, 0x200F},
                                                           {0x2028, 0x202E}, {0x2060, 0x2060}, {0x2066, 0x2069},
                                                           {0xFEFF, 0xFEFF}};
  return std::any_of(std::begin(kRanges), std::end(kRanges),
                     [&](const auto& range) { return character >= range.first && character <= range.second; });
}

// Converts text from Shift-JIS (Windows code page 932), which Japanese instruments write, to UTF-8. Returns nullopt if
// the text is not valid Shift-JIS, or has no byte that would be a control character in Latin-1.
std::optional<std::string> fromCp932(const std::string& text) {
  const bool may_be = std::any_of(text.begin(), text.end(), [](char c) { return c >= '\x81' && c <= '\x9F'; });
  const std::unique_ptr<void, int (*)(iconv_t)> converter(may_be ? iconv_open("UTF-8", "CP932") : nullptr, iconv_close);
  // iconv_open() returns -1 on failure.
  if (!may_be || converter.get() == reinterpret_cast<iconv_t>(-1)) {  // NOLINT(performance-no-int-to-ptr)
    return std::nullopt;
  }
  std::string result(3 * text.size(), '\0');
  char* in = const_cast<char*>(text.data());
  char* out = result.data();
  std::size_t left = text.size();
  std::size_t room = result.size();
  if (iconv(converter.get(), &in, &left, &out, &room) == static_cast<std::size_t>(-1)) {
    return std::nullopt;
  }
  result.resize(result.size() - room);
  return result;
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
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at != end;) {
    if (!takeCharacter(at, end)) {
      return false;
    }
  }
  return true;
}

std::string toUtf8(const std::string& text) {
  if (isUtf8(text)) {
    return text;
  }
  if (const auto japanese = fromCp932(text)) {
    return *japanese;
  }
  std::string result;
  for (const char c : text) {
    Utf8::encode(static_cast<unsigned char>(c), std::back_inserter(result));
  }
  return result;
}

std::string oneLine(const std::string& text) {
  std::string result;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at != end;) {
    const char* const begin = at;
    const auto character = takeCharacter(at, end);
    const std::string bytes(begin, at);
    const bool blank = character == U'\n' || character == U'\r' || character == U'\t';
    result += blank ? " " : !character || isHarmful(*character) ? escaped(bytes) : bytes;
  }
  return result;
}

std::string quoted(const std::string& text) {
  constexpr std::size_t kLongest = 60;
  std::size_t end = std::min(kLongest, text.size());
  while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
    --end;  // does not split a character
  }
  return fmt::format("'{}{}'", oneLine(text.substr(0, end)), end < text.size() ? "..." : "");
}

std::string join(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

void refuseNamedPipe(const std::string& path) {
  struct stat status{};
  // A pipe that the shell made for <(COMMAND) already has a writer.
  const bool is_open = path.rfind("/dev/", 0) == 0 || path.rfind("/proc/", 0) == 0;
  element::refuseIf<std::runtime_error>(
      !is_open && stat(path.c_str(), &status) == 0 && S_ISFIFO(status.st_mode),
      "is a pipe; accepted: a regular file, or the output of a command as <(COMMAND)");
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
  element::refuseIf<std::runtime_error>(text.size() > maximum_size, "more than {0} bytes; accepted: at most {0}",
                                        maximum_size);
  return text;
}

std::string readInput(const std::string& path, std::size_t maximum_size, const std::string& accepted) {
  try {
    return readFile(path, maximum_size);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(oneLine(path + ": " + error.what() + accepted));
  }
}

}  // namespace rubber_suspension::log
