// Small helpers on text that the readers share.
#pragma once

#include <locale.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rubber_suspension::log {

/// Returns the locale in which a decimal point is a point, whatever the user's is.
inline locale_t cLocale() {
  static const locale_t locale = newlocale(LC_ALL_MASK, "C", nullptr);
  return locale;
}

constexpr std::string_view kBlanks = " \t";

/// Returns the text without blanks at its ends.
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

/// Returns true if all bytes belong to characters of UTF-8.
bool isUtf8(const std::string& text);

/// Converts text to UTF-8 from Shift-JIS if it can only be that, else from Latin-1; UTF-8 is returned unchanged.
std::string toUtf8(const std::string& text);

/// Returns the text as a terminal may show it, on one line: blanks for line ends and tabs; \xNN for control characters,
/// those that change the direction of writing, and bytes that are no UTF-8.
std::string oneLine(const std::string& text);

/// Returns text of a user in quotes, for one line of an error: shortened if it is long, and as by oneLine().
std::string quoted(const std::string& text);

/// Returns the ending of a noun that counts things.
inline const char* pluralOf(std::size_t count) { return count == 1 ? "" : "s"; }

/// Joins names to a list "a, b, c".
std::string join(const std::vector<std::string>& names);

/// Throws std::runtime_error for a named pipe, which would block if no program writes to it.
void refuseNamedPipe(const std::string& path);

/// Returns the content of a file of at most `maximum_size` bytes. Throws std::runtime_error with the reason.
std::string readFile(const std::string& path, std::size_t maximum_size);

/// Reads a file; the error is one line, from the path to what is accepted.
std::string readInput(const std::string& path, std::size_t maximum_size, const std::string& accepted = "");

}  // namespace rubber_suspension::log
