// Small helpers on text that the readers share.
#pragma once

#include <locale.h>

#include <cstddef>
#include <string>
#include <vector>

namespace rubber_suspension::log {

/// The locale in which a decimal point is a point, whatever the user's is.
inline locale_t cLocale() {
  static const locale_t locale = newlocale(LC_ALL_MASK, "C", nullptr);
  return locale;
}

/// The text without blanks at its ends.
inline std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string::npos ? std::string() : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The text with a blank for each control character: an error is one line, whatever the file that it quotes holds.
std::string oneLine(std::string text);

/// Text that a user wrote, in quotes and fit for one line of an error: cut where it is long, no control characters.
std::string quoted(const std::string& text);

/// Names as a list "a, b, c".
std::string join(const std::vector<std::string>& names);

/// The content of a file of at most that many bytes. Throws std::runtime_error with the reason.
std::string readFile(const std::string& path, std::size_t maximum_size);

}  // namespace rubber_suspension::log
