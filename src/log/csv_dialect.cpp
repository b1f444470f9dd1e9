// Finds the dialect of a text file: separator, decimal mark, preamble, header, row of units.
#include "log/csv_dialect.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>
#include <stdexcept>

#include "element/refuse.h"
#include "log/log_columns.h"
#include "log/number_marks.h"
#include "log/text.h"
#include "log/time_text.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::log {
namespace {

// The name of a separator and the one or two characters that represent it.
struct SeparatorInfo {
  const char* name;
  std::string_view marks;
};

const SeparatorInfo& infoOf(Separator separator) {
  static constexpr SeparatorInfo kTable[] = {{"comma", ","}, {"semicolon", ";"}, {"tab", "\t"}, {"blank", kBlanks}};
  return kTable[static_cast<std::size_t>(separator)];
}

Field makeField(std::string_view text) {
  text = trimmedView(text);
  const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  return {quoted ? trimmedView(text.substr(1, text.size() - 2)) : text, quoted};
}

// Returns the end of the field that begins at `begin`. A quote inside a field that does not begin with a quote is text.
std::size_t fieldEnd(std::string_view line, std::size_t begin, Separator separator) {
  const std::size_t first = line.find_first_not_of(kBlanks, begin);
  const char mark = infoOf(separator).marks.front();
  const char other_mark = infoOf(separator).marks.back();
  bool in_quotes = first != std::string_view::npos && line[first] == '"';
  for (std::size_t i = in_quotes ? first + 1 : begin; i < line.size(); ++i) {
    if (line[i] == '"' && in_quotes) {
      in_quotes = i + 1 < line.size() && line[i + 1] == '"';  // a doubled quote stands for one quote in the text
      i += in_quotes ? 1 : 0;
    } else if (!in_quotes && (line[i] == mark || line[i] == other_mark)) {
      return i;
    }
  }
  return line.size();
}

// Joins a unit in brackets to the name before it, because blanks split "Time [s]" into two words.
void joinUnits(std::vector<Field>& fields) {
  std::vector<Field> joined;
  for (const Field& field : fields) {
    const bool bracket = !field.quoted && !field.text.empty() && (field.text[0] == '[' || field.text[0] == '(');
    if (bracket && !joined.empty()) {
      const char* begin = joined.back().text.data();
      joined.back().text = {begin, static_cast<std::size_t>(field.text.data() + field.text.size() - begin)};
    } else {
      joined.push_back(field);
    }
  }
  fields = joined;
}

// Splits a line into names of several words, which are separated by two or more blanks or by a tab.
std::vector<Field> splitAtWideGaps(std::string_view line) {
  std::vector<Field> fields;
  line = trimmedView(line);
  while (!line.empty()) {
    const std::size_t gap = std::min({line.find("  "), line.find('\t'), line.size()});
    fields.push_back(makeField(line.substr(0, gap)));
    line = trimmedView(line.substr(gap));
  }
  return fields;
}

std::vector<Field> fieldsOf(std::string_view line, Separator separator) {
  std::vector<Field> fields;
  splitFields(line, separator, fields);
  return fields;
}

// Returns the names in a line. If the separator is blanks and the number of words is not `count`, the line is split at
// wide gaps, provided that this gives `count` names.
std::vector<Field> namesIn(std::string_view line, Separator separator, std::size_t count) {
  std::vector<Field> fields = fieldsOf(line, separator);
  if (separator == Separator::blanks) {
    joinUnits(fields);
    const std::vector<Field> wide = splitAtWideGaps(line);
    return fields.size() != count && wide.size() == count ? wide : fields;
  }
  while (fields.size() > 1 && fields.back().text.empty()) {
    fields.pop_back();  // the line ends in a separator
  }
  return fields;
}

std::string_view withoutCommentMark(std::string_view line) {
  if (!isComment(line)) {
    return line;
  }
  line = trimmedView(line);
  return line.substr(std::min(line.find_first_not_of("#%!/"), line.size()));
}

bool anyNumber(const std::vector<Field>& fields) {
  return std::any_of(fields.begin(), fields.end(), [](const Field& field) { return isNumberField(field.text); });
}

// Returns true for a row with the data types of the columns, such as "f8;f4", which INCA writes below the names.
bool isRowOfTypes(std::string_view line) {
  static const std::regex kType(
      "[fiub](1|2|4|8|16|32|64)|float|double|single|real|int(8|16|32|64)?|uint(8|16|32|64)?|"
      "boolean|string");
  const std::vector<Field> fields = fieldsOf(line, separatorOf(line));
  return fields.size() > 1 && std::all_of(fields.begin(), fields.end(), [](const Field& field) {
           return field.text.size() < 8 && std::regex_match(lowerCase(std::string(field.text)), kType);
         });
}

// Returns true for a header whose first cell contains the number of the test piece. No unit stands below such a cell.
bool isBeneathCorner(const std::vector<Field>& fields, const std::vector<std::string>& units) {
  return !units.empty() && units[0].empty() && !anyNumber({fields.begin() + 1, fields.end()});
}

// Returns the cells below the names of `count` columns; empty if the line is not a row of units.
std::vector<std::string> cellsBelow(std::string_view line, Separator separator, std::size_t count) {
  std::vector<std::string> cells;
  bool any_unit = false;
  for (const Field& field : namesIn(line, separator, count)) {
    cells.emplace_back(field.text);
    if (isNumberField(field.text)) {
      return {};
    }
    const auto unit = unitInField(cells.back());
    any_unit = any_unit || (unit && !unit->empty() && quantityOfUnit(*unit));
  }
  cells.resize(any_unit && cells.size() <= count ? count : 0);
  return cells;
}

std::vector<ColumnName> columnNames(const std::vector<Field>& fields, const std::vector<std::string>& below) {
  std::vector<ColumnName> names;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string text(fields[i].text);
    names.push_back(below.empty() ? parseColumnName(text) : parseColumnName(text, below[i]));
  }
  return names;
}

// Returns the columns that the user gave by number, counted from 0; empty if the user gave a column by name.
std::vector<std::size_t> numbersToldIn(const LogFormat& format) {
  std::vector<std::size_t> places;
  for (const LogFormat::Channel& channel : format.of) {
    const std::string& name = channel.column;
    if (name.empty()) {
      continue;
    }
    if (wholeNumber(name) == 0) {
      return {};
    }
    places.push_back(wholeNumber(name) - 1);
  }
  return places;
}

}  // namespace

std::string toString(Separator separator) { return infoOf(separator).name; }

Separator separatorOf(std::string_view line) {
  const auto holds = [&](Separator separator) { return fieldEnd(line, 0, separator) < line.size(); };
  if (trimmedView(line).find('\t') != std::string_view::npos && holds(Separator::tab)) {
    return Separator::tab;
  }
  if (holds(Separator::semicolon)) {
    return Separator::semicolon;
  }
  return holds(Separator::comma) ? Separator::comma : Separator::blanks;
}

void splitFields(std::string_view line, Separator separator, std::vector<Field>& fields) {
  fields.clear();
  std::size_t begin = 0;
  if (separator == Separator::blanks) {
    line = trimmedView(line);
  }
  while (true) {
    const std::size_t end = fieldEnd(line, begin, separator);
    fields.push_back(makeField(line.substr(begin, end - begin)));
    if (end == line.size()) {
      return;
    }
    begin = separator == Separator::blanks ? line.find_first_not_of(kBlanks, end) : end + 1;
  }
}

bool isComment(std::string_view line) {
  const std::size_t first = line.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) {
    return false;
  }
  return line[first] == '#' || line[first] == '%' || line[first] == '!' || line.substr(first, 2) == "//";
}

bool isNumberField(std::string_view text) {
  constexpr std::size_t kLongest = 64;
  std::string signed_number;
  std::string joined;
  std::string number(withoutGroupMarks(withSignJoined(text.substr(0, kLongest), signed_number), joined));
  std::replace(number.begin(), number.end(), ',', '.');
  for (std::size_t mark = number.find('.'); mark != number.rfind('.'); mark = number.find('.')) {
    number.erase(mark, 1);  // the mark separates thousands
  }
  return text.size() <= kLongest && (parseNumber(number).has_value() || isTimeText(text));
}

HeaderFinder::HeaderFinder(const LogFormat& format)
    : looks_like_header_([format](const std::vector<ColumnName>& names) { return looksLikeHeader(names, format); }),
      accepted_("the names of the columns, or their order with --columns time displacement force"),
      numbers_(numbersToldIn(format)) {}

std::optional<CsvHeader> HeaderFinder::add(const TextLine& line) {
  if (trimmedView(line.text).empty() || isRowOfTypes(line.text)) {
    return std::nullopt;
  }
  lines_.push_back({line.number, toUtf8(line.text)});
  // A header is confirmed by the two lines after it, because the first of them may be a row of units.
  return lines_.size() < 3 ? std::nullopt : candidate(lines_.size() - 3);
}

std::optional<CsvHeader> HeaderFinder::atEnd(bool needs_row) const {
  for (std::size_t i = lines_.size() < 3 ? 0 : lines_.size() - 2; i < lines_.size(); ++i) {
    auto found = candidate(i);
    if (found && (!needs_row || found->next_line <= lines_.back().number)) {
      return found;
    }
  }
  return std::nullopt;
}

CsvHeader HeaderFinder::finish() const {
  const auto found = atEnd(false);
  return found ? *found : bestGuess();
}

std::optional<CsvHeader> HeaderFinder::candidate(std::size_t i) const {
  if (!numbers_.empty()) {
    return numberedColumns(i);
  }
  for (const bool units_follow : {false, true}) {
    if (auto header = namedColumns(i, units_follow)) {
      return header;
    }
  }
  return std::nullopt;
}

// The number of fields in the first row of numbers decides how blanks split the names.
std::optional<CsvHeader> HeaderFinder::namedColumns(std::size_t i, bool units_follow) const {
  const std::size_t following = i + (units_follow ? 2 : 1);
  const std::string_view line = withoutCommentMark(lines_[i].text);
  CsvHeader header;
  header.separator = separatorOf(line);
  header.line = lines_[i].number;
  header.has_units_row = units_follow;
  const bool row_is_there = following < lines_.size();
  header.next_line = row_is_there ? lines_[following].number : lines_.back().number + 1;
  const std::size_t count = row_is_there ? fieldsOf(lines_[following].text, header.separator).size() : 0;
  std::vector<Field> fields = namesIn(line, header.separator, count);
  header.comments_follow = fields.size() > 2 && lowerCase(std::string(fields.back().text)) == "comment";
  fields.resize(fields.size() - (header.comments_follow ? 1 : 0));
  std::vector<std::string> units;
  if (units_follow) {
    units = i + 1 < lines_.size() ? cellsBelow(withoutCommentMark(lines_[i + 1].text), header.separator, fields.size())
                                  : units;
    if (units.empty()) {
      return std::nullopt;
    }
  } else {
    units = unitsAbove(header, i, fields.size());
  }
  header.names = columnNames(fields, units);
  const bool fits = (!anyNumber(fields) || isBeneathCorner(fields, units)) && looks_like_header_(header.names) &&
                    confirmed(header, isComment(lines_[i].text), following);
  return fits ? std::optional<CsvHeader>(header) : std::nullopt;
}

bool HeaderFinder::confirmed(const CsvHeader& header, bool in_comment, std::size_t following) const {
  if (following >= lines_.size()) {
    return !in_comment;  // the file ends behind the header
  }
  if (isComment(lines_[following].text)) {
    return !in_comment;  // a comment that precedes another comment is no header
  }
  const std::vector<Field> fields = fieldsOf(lines_[following].text, header.separator);
  return fields.size() >= header.names.size() && anyNumber(fields);
}

std::optional<CsvHeader> HeaderFinder::numberedColumns(std::size_t i) const {
  if (isComment(lines_[i].text)) {
    return std::nullopt;
  }
  constexpr std::array kSeparators = {Separator::tab, Separator::semicolon, Separator::comma, Separator::blanks};
  const bool separated = std::any_of(kSeparators.begin(), kSeparators.end(), [&](Separator separator) {
    return fieldsOf(lines_[i].text, separator).size() > 1;
  });
  for (const Separator separator : kSeparators) {
    const std::vector<Field> fields = fieldsOf(lines_[i].text, separator);
    const bool is_row =
        (fields.size() > 1 || !separated) && std::all_of(numbers_.begin(), numbers_.end(), [&](std::size_t place) {
          return place < fields.size() && isNumberField(fields[place].text);
        });
    if (is_row) {
      CsvHeader header;
      header.separator = separator;
      header.next_line = lines_[i].number;
      for (std::size_t place = 0; place < fields.size(); ++place) {
        header.names.push_back(parseColumnName(std::to_string(place + 1)));
      }
      addNamesAbove(header, i);
      return header;
    }
  }
  return std::nullopt;
}

// Returns the units in a line of the preamble such as "Unit;s;mm;kN"; empty if there is no such line.
std::vector<std::string> HeaderFinder::unitsAbove(const CsvHeader& header, std::size_t line, std::size_t count) const {
  constexpr std::size_t kMostLines = 20;
  for (std::size_t i = line; i-- > 0 && line - i <= kMostLines;) {
    const std::vector<Field> fields = namesIn(withoutCommentMark(lines_[i].text), header.separator, 0);
    if (fields.size() > 1 && lowerCase(std::string(fields[0].text)).find("unit") != std::string::npos) {
      std::vector<std::string> units = cellsBelow(withoutCommentMark(lines_[i].text), header.separator, fields.size());
      if (units.size() == count + 1) {  // the label "Unit" has a cell of its own
        units.erase(units.begin());
      } else if (!units.empty()) {
        units[0].clear();
      }
      units.resize(units.empty() ? 0 : count);
      return units;
    }
  }
  return {};
}

// Adds the names in the lines above the first row to the header, and the units if a row of units lies in between. A
// line of numbers directly above is taken as a row, so that reading it reports the error.
void HeaderFinder::addNamesAbove(CsvHeader& header, std::size_t row) const {
  const std::size_t count = header.names.size();
  const auto fields_above = [&](std::size_t lines) {
    return lines > row ? std::vector<Field>()
                       : namesIn(withoutCommentMark(lines_[row - lines].text), header.separator, count);
  };
  const auto are_names = [&](const std::vector<Field>& fields) {
    return fields.size() > 1 && fields.size() <= count && !anyNumber(fields);
  };
  std::vector<Field> first = fields_above(1);
  std::vector<Field> second = fields_above(2);
  if (first.size() == count && anyNumber(first)) {
    header.next_line = lines_[row - 1].number;
    return;
  }
  std::vector<std::string> units;
  if (!first.empty()) {
    units = cellsBelow(withoutCommentMark(lines_[row - 1].text), header.separator, count);
  }
  if (units.empty() && !are_names(first) && !(count == 1 && first.size() == 1 && !anyNumber(first))) {
    return;
  }
  const bool two_rows = !units.empty() && are_names(second);
  std::vector<std::string> above = unitsAbove(header, row - 1, first.size());
  above.resize(above.empty() ? 0 : count);
  first.resize(count);  // a row may have more fields than the header has names
  second.resize(count);
  const bool units_alone = !two_rows && !units.empty() && std::all_of(units.begin(), units.end(), unitInField);
  for (std::size_t i = 0; i < count && units_alone; ++i) {
    header.names[i] = parseColumnName(header.names[i].text, units[i]);
  }
  header.names = two_rows ? columnNames(second, units) : units_alone ? header.names : columnNames(first, above);
  header.has_units_row = two_rows || units_alone;
  header.line = lines_[row - (two_rows ? 2 : 1)].number;
}

// Interprets line i as a header, or as the row of units below a header.
CsvHeader HeaderFinder::guessAt(std::size_t i) const {
  CsvHeader header;
  header.separator = separatorOf(lines_[i].text);
  std::vector<Field> fields = namesIn(lines_[i].text, header.separator, 0);
  std::vector<std::string> units = cellsBelow(lines_[i].text, header.separator, fields.size());
  const std::vector<Field> above = i > 0 ? namesIn(lines_[i - 1].text, header.separator, 0) : std::vector<Field>();
  header.has_units_row = !units.empty() && above.size() == fields.size() && !anyNumber(above);
  fields = header.has_units_row ? above : fields;
  header.names = columnNames(fields, header.has_units_row ? units : unitsAbove(header, i, fields.size()));
  header.line = lines_[i - (header.has_units_row ? 1 : 0)].number;
  header.next_line = lines_[i].number + 1;
  return header;
}

// Returns the line that is most likely meant to be the header, so that the error can refer to it. That is the line
// directly above the first row of numbers, if there is one.
CsvHeader HeaderFinder::bestGuess() const {
  const auto all_numbers = [](const std::vector<Field>& fields) {
    return std::all_of(fields.begin(), fields.end(), [](const Field& field) { return isNumberField(field.text); });
  };
  std::optional<CsvHeader> guess;
  bool found = false;
  for (std::size_t i = 0; i < lines_.size() && !found; ++i) {
    const CsvHeader header = guessAt(i);
    const std::vector<Field> fields = namesIn(lines_[i].text, header.separator, 0);
    const bool is_row = !isComment(lines_[i].text) && all_numbers(fields);
    const std::vector<Field> next = i + 1 < lines_.size() && !isComment(lines_[i + 1].text)
                                        ? fieldsOf(lines_[i + 1].text, header.separator)
                                        : std::vector<Field>();
    const bool above_numbers =
        !anyNumber(fields) && next.size() == fields.size() && next.size() > 1 && all_numbers(next);
    const bool looks = looks_like_header_(header.names);
    found = looks || above_numbers || is_row;
    if (!is_row && (found || (!guess && anyNumber(next) && !anyNumber(fields)))) {
      guess = header;
    }
  }
  const bool any_number = !lines_.empty() && !isComment(lines_[0].text) &&
                          anyNumber(namesIn(lines_[0].text, separatorOf(lines_[0].text), 0));
  element::refuseIf<std::runtime_error>(!guess && any_number,
                                        "no header: the first line has {}; accepted: a line with {}",
                                        quoted(lines_.empty() ? "" : lines_[0].text), accepted_);
  element::refuseIf<std::runtime_error>(!guess, "no header within {} lines; accepted: a line with {}", lines_.size(),
                                        accepted_);
  return *guess;
}

}  // namespace rubber_suspension::log
