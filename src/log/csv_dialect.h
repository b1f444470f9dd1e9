// Finds the dialect of a text file: separator, decimal mark, preamble, header, row of units.
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
  std::size_t number = 0;  ///< counted from 1
  std::string text;
};

/// The separator of fields. `blanks` stands for any number of blanks and tabs.
enum class Separator { comma, semicolon, tab, blanks };

std::string toString(Separator separator);

/// Returns the separator of a line of names: the first of tab, semicolon, comma and blank that the line contains.
Separator separatorOf(std::string_view line);

/// A field of a line: its text without the blanks and quotes around it.
struct Field {
  std::string_view text;
  bool quoted = false;
};

/// Splits a line into fields. Separators inside quotes are part of the text. An empty line has one empty field.
void splitFields(std::string_view line, Separator separator, std::vector<Field>& fields);

/// The header of a file, and the line at which its rows begin.
struct CsvHeader {
  Separator separator = Separator::comma;
  std::vector<ColumnName> names;
  std::size_t line = 0;          ///< number of the line with the names; 0 if the columns are given by number
  bool has_units_row = false;    ///< true if the next line is a row of units
  bool comments_follow = false;  ///< true if rows may end in a comment without a column, as in LabVIEW's files
  std::size_t next_line = 0;     ///< number of the first line that may be a row
};

/// Largest number of lines before the first row.
constexpr std::size_t kMaximumHeadLines = 1000;

/// Finds the header among the first lines of a file by the names of the columns. Lines before it are a preamble.
class HeaderFinder {
 public:
  using LooksLikeHeader = std::function<bool(const std::vector<ColumnName>&)>;

  /// Finds the header of a log.
  explicit HeaderFinder(const LogFormat& format);

  /// Finds a header whose names satisfy `looks`. `accepted` describes such names in errors.
  HeaderFinder(LooksLikeHeader looks, std::string accepted)
      : looks_like_header_(std::move(looks)), accepted_(std::move(accepted)) {}

  /// Adds the next line. Returns the header as soon as the lines after the header confirm it.
  std::optional<CsvHeader> add(const TextLine& line);

  /// Returns the header of a file that has no further lines. If `needs_row` is true, a row has to follow the header.
  std::optional<CsvHeader> atEnd(bool needs_row) const;

  /// Returns the header of a file without further lines, or else the line most similar to a header. Throws if there is
  /// no such line.
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
  std::vector<std::size_t> numbers_;  // columns that the user gave by number, counted from 0; otherwise empty
  std::vector<TextLine> lines_;       // lines that are neither blank nor rows of types, in UTF-8
};

/// Returns true if the line is a comment, which begins with #, %, ! or //.
bool isComment(std::string_view line);

/// Returns true for a decimal number, with points or commas, and for a time of day or a date with a time.
bool isNumberField(std::string_view text);

}  // namespace rubber_suspension::log
