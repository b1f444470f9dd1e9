// Dialect of a text file: separator, decimal mark, preamble, header, row of units.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "log/column_name.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {

/// One line of a file, unchanged.
struct TextLine {
  std::size_t number = 0;  ///< from 1
  std::string text;
};

/// The separator of fields; `blanks` are any number of blanks and tabs.
enum class Separator { comma, semicolon, tab, blanks };

std::string toString(Separator separator);

/// Returns the separator of a line of names, by rank: beside a tab or a semicolon, commas and blanks are within fields.
Separator separatorOf(std::string_view line);

/// A field of a line: its text without blanks and quotes around it.
struct Field {
  std::string_view text;
  bool quoted = false;
};

/// Splits a line into fields. Separators within quotes separate nothing. An empty line has one empty field.
void splitFields(std::string_view line, Separator separator, std::vector<Field>& fields);

/// The header of a file and where its rows begin.
struct CsvHeader {
  Separator separator = Separator::comma;
  std::vector<ColumnName> names;
  std::size_t line = 0;          ///< number of the line with the names; 0: none, columns are found by number
  bool has_units_row = false;    ///< in the next line
  bool comments_follow = false;  ///< a row may end in a comment, which has no name here, as in LabVIEW's files
  std::size_t next_line = 0;     ///< number of the first line that may be a row
};

/// Largest number of lines before the first row.
constexpr std::size_t kMaximumHeadLines = 1000;

/// Finds the header among the first lines of a file, by the names of the columns: lines before it are a preamble.
class HeaderFinder {
 public:
  using LooksLikeHeader = std::function<bool(const std::vector<ColumnName>&)>;

  /// Finds the header of a log.
  explicit HeaderFinder(const LogFormat& format);

  /// Finds a header whose names satisfy `looks`; `accepted`: their description for errors.
  HeaderFinder(LooksLikeHeader looks, std::string accepted)
      : looks_like_header_(std::move(looks)), accepted_(std::move(accepted)) {}

  /// Adds the next line; returns the header as soon as the lines behind it confirm it.
  std::optional<CsvHeader> add(const TextLine& line);

  /// Returns the header of a file that ends here; `needs_row`: only one with a row behind it.
  std::optional<CsvHeader> atEnd(bool needs_row) const;

  /// Returns the header of a file that ends here, or the line that most looks like one. Throws std::runtime_error if
  /// there is none.
  CsvHeader finish() const;

 private:
  std::optional<CsvHeader> candidate(std::size_t i) const;
  std::optional<CsvHeader> namedColumns(std::size_t i, bool units_follow) const;
  std::optional<CsvHeader> numberedColumns(std::size_t i) const;
  bool confirmed(const CsvHeader& header, bool in_comment, std::size_t following) const;
  void addNamesAbove(CsvHeader& header, std::size_t row) const;
  std::vector<std::string> unitsAbove(const CsvHeader& header, std::size_t line, std::size_t count) const;
  CsvHeader guessAt(std::size_t i) const;
  CsvHeader bestGuess() const;

  LooksLikeHeader looks_like_header_;
  std::string accepted_;
  std::vector<std::size_t> numbers_;  // columns that the user gave by number, from 0; else empty
  std::vector<TextLine> lines_;       // lines that are neither blank nor rows of types, in UTF-8
};

/// Returns true for a line that is a comment: it begins with #, %, ! or //.
bool isComment(std::string_view line);

/// Returns true for a number in decimal notation, with points and commas, or a time as a clock or a calendar shows it.
bool isNumberField(std::string_view text);

}  // namespace rubber_suspension::log
