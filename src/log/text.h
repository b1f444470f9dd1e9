// Functions on text and files that the readers share.
#pragma once

#include <locale.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rubber_suspension::log {

/// Returns a locale in which the decimal mark is a point, independent of the user's locale.
inline locale_t cLocale() {
  static const locale_t locale = newlocale(LC_ALL_MASK, "C", nullptr);
  return locale;
}

constexpr std::string_view kBlanks = " \t";

/// Returns the text without the blanks at its ends.
inline std::string_view trimmedView(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}
inline std::string trimmed(std::string_view text) { return std::string(trimmedView(text)); }

inline bool startsWith(std::string_view text, std::string_view start) { return text.substr(0, start.size()) == start; }

inline bool endsWith(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

/// Returns the text with ASCII letters in lower case.
std::string lowerCase(std::string text);

/// Returns true if the text is valid UTF-8.
bool isUtf8(const std::string& text);

/// Returns UTF-8 unchanged. Converts other text from Shift-JIS if it can be nothing else, and otherwise from Latin-1.
std::string toUtf8(const std::string& text);

/// Returns the text in a form that is safe to show on one line of a terminal. Line ends and tabs become blanks. Bytes
/// that are not UTF-8, and characters that control the terminal or the direction of writing, become \xNN.
std::string oneLine(const std::string& text);

/// Returns text from a user or a file in quotes for an error: on one line as by oneLine(), and shortened if it is long.
std::string quoted(const std::string& text);

/// Returns the plural ending "s", or "" if the count is 1.
inline const char* pluralOf(std::size_t count) { return count == 1 ? "" : "s"; }

std::string join(const std::vector<std::string>& names);

/// Throws std::runtime_error for a named pipe. Reading it would block if no program writes to it.
void refuseNamedPipe(const std::string& path);

/// Returns the content of a file. Throws std::runtime_error with the reason, also for more than `maximum_size` bytes.
std::string readFile(const std::string& path, std::size_t maximum_size);

/// Returns the content of a file. The error is one line that begins with the path and ends with `accepted`.
std::string readInput(const std::string& path, std::size_t maximum_size, const std::string& accepted = "");

}  // namespace rubber_suspension::log
