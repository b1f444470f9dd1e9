// Small helpers on text that the readers share.
#pragma once

#include <locale.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rubber_suspension::log {

/// The locale in which a decimal point is a point, whatever the user's is.
inline locale_t cLocale() {
  static const locale_t locale = newlocale(LC_ALL_MASK, "C", nullptr);
  return locale;
}

constexpr std::string_view kBlanks = " \t";

/// The text without blanks at its ends.
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

/// The text with ASCII letters in lower case.
std::string lowerCase(std::string text);

/// True where all bytes belong to characters of UTF-8.
bool isUtf8(const std::string& text);

/// The text in UTF-8: as it is where it is UTF-8, else read as Latin-1, in which every byte is a character.
std::string toUtf8(const std::string& text);

/// The text as a terminal may show it, on one line: blanks for line ends and tabs; control characters, those that turn
/// the direction of writing, and bytes that are no UTF-8 as \xNN.
std::string oneLine(const std::string& text);

/// Text that a user wrote, in quotes and fit for one line of an error: cut where it is long, as oneLine().
std::string quoted(const std::string& text);

/// The ending of a noun that counts things.
inline const char* pluralOf(std::size_t count) { return count == 1 ? "" : "s"; }

/// Names as a list "a, b, c".
std::string join(const std::vector<std::string>& names);

/// Throws std::runtime_error for a named pipe, whose other end nobody may ever open.
void refuseNamedPipe(const std::string& path);

/// The content of a file of at most that many bytes. Throws std::runtime_error with the reason.
std::string readFile(const std::string& path, std::size_t maximum_size);

/// Reads a file; the error is one line, from the path to what is accepted.
std::string readInput(const std::string& path, std::size_t maximum_size, const std::string& accepted = "");

}  // namespace rubber_suspension::log
