// Interprets the points and commas in the numbers of a text file.
#include "log/number_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/erase.hpp>
#include <cmath>
#include <regex>
#include <stdexcept>

#include "element/refuse.h"
#include "log/column_name.h"
#include "log/sample_rules.h"
#include "log/text.h"

namespace rubber_suspension::log {
namespace {

constexpr std::size_t kGroup = 3;  // digits in a group

const char* nameOfMark(char mark) { return mark == ',' ? "comma" : "point"; }
char otherMark(char mark) { return mark == ',' ? '.' : ','; }
bool isMarkDigit(char c) { return c >= '0' && c <= '9'; }

// Returns true if the marks separate groups of three digits. The first group has one to three digits.
bool isGrouped(std::string_view digits, char mark) {
  std::size_t at = digits.find(mark);
  if (at == 0 || at > kGroup) {
    return false;
  }
  while (at != std::string_view::npos) {
    const std::size_t next = std::min(digits.find(mark, at + 1), digits.size());
    if (next - at - 1 != kGroup) {
      return false;
    }
    at = next == digits.size() ? std::string_view::npos : next;
  }
  return true;
}

double relativeStep(double from, double to) {
  const double scale = std::max(std::abs(from), std::abs(to));
  return scale > 0.0 ? std::abs(to - from) / scale : 0.0;
}

}  // namespace

std::string_view withoutGroupMarks(std::string_view text, std::string& joined) {
  static const std::regex kGrouped("[+-]?[0-9]{1,3}('| |\u2019|\u00A0|\u202F)[0-9]{3}(?:\\1[0-9]{3})*(?:[.,][0-9]*)?");
  std::cmatch match;
  if (text.size() > kLongestNumber || text.find_first_of("' \xC2\xE2") == std::string_view::npos ||
      !std::regex_match(text.data(), text.data() + text.size(), match, kGrouped)) {
    return text;
  }
  joined = text;
  boost::algorithm::erase_all(joined, match.str(1));
  return joined;
}

std::string_view withSignJoined(std::string_view text, std::string& joined) {
  if (text.size() < 3 || (text[0] != '+' && text[0] != '-') || kBlanks.find(text[1]) == std::string_view::npos) {
    return text;
  }
  const std::size_t digits = text.find_first_not_of(kBlanks, 1);
  if (digits == std::string_view::npos || !(isMarkDigit(text[digits]) || text[digits] == '.' || text[digits] == ',')) {
    return text;
  }
  joined = text[0] + std::string(text.substr(digits));
  return joined;
}

// The digits and marks of a number, without its sign and exponent.
struct NumberMarks::Marks {
  explicit Marks(std::string_view text) {
    const std::size_t first = text.find_first_of("0123456789.,");
    const std::size_t exponent = std::min(text.find_first_of("eE"), text.size());
    digits = text.substr(std::min(first, exponent), exponent - std::min(first, exponent));
    has_exponent = exponent < text.size();
    points = static_cast<std::size_t>(std::count(digits.begin(), digits.end(), '.'));
    commas = static_cast<std::size_t>(std::count(digits.begin(), digits.end(), ','));
    const std::size_t last_mark = digits.find_last_of(".,");
    last = last_mark == std::string_view::npos ? '\0' : digits[last_mark];
    before = digits.substr(0, std::min(last_mark, digits.size()));
  }

  // Returns true for numbers such as "1.072", which may mean 1072; false for "0.125" and "1.07", which cannot.
  bool mayBeThousands() const {
    return points + commas == 1 && !has_exponent && isGrouped(digits, last) && digits.front() != '0';
  }

  std::string_view digits;
  std::string_view before;  // digits before the last mark
  bool has_exponent = false;
  std::size_t points = 0;
  std::size_t commas = 0;
  char last = '\0';
};

void NumberMarks::settle(char decimal, std::string_view text, std::size_t line) {
  if (decimal_ == decimal) {
    return;
  }
  if (decimal_ == '\0' && assumed_ == otherMark(decimal)) {
    throw OtherDecimalMark{decimal};
  }
  element::refuseIf<std::runtime_error>(decimal_ != '\0',
                                        "{} has a decimal {}, but {} has a decimal {}; accepted: one decimal mark "
                                        "throughout, with only the other mark as thousands separator",
                                        quoted(std::string(text)), nameOfMark(decimal),
                                        told_               ? "--decimal"
                                        : decimal_line_ > 0 ? fmt::format("line {}", decimal_line_)
                                                            : "another line",
                                        nameOfMark(decimal_));
  decimal_ = decimal;
  decimal_line_ = line;
}

void NumberMarks::lookAt(std::string_view text, std::size_t channel, std::size_t line) {
  ColumnMarks& column = columns_[channel];
  const Marks marks(text);
  last_marked_ = marks.last != '\0';
  last_may_be_either_ = marks.mayBeThousands();
  if (!last_marked_ || column.told != '\0') {
    return;
  }
  marked_ = true;
  if (last_may_be_either_) {
    if (decimal_ == '\0' && assumed_ == otherMark(marks.last)) {
      throw std::runtime_error(
          fmt::format("{} has a {} where other numbers have a {}; accepted: --decimal , or --decimal .",
                      quoted(std::string(text)), nameOfMark(marks.last), nameOfMark(assumed_)));
    }
    assumed_ = decimal_ == '\0' ? marks.last : assumed_;
    const bool first = column.line == 0 && (decimal_ == '\0' || decimal_ == marks.last);
    column.line = first ? line : column.line;
    column.text = first ? std::string(text) : column.text;
    return;
  }
  const bool both = marks.points > 0 && marks.commas > 0;
  const std::size_t last_count = marks.last == '.' ? marks.points : marks.commas;
  const bool wrong = both ? last_count > 1 || !isGrouped(marks.before, otherMark(marks.last))
                          : last_count > 1 && !isGrouped(marks.digits, marks.last);
  if (wrong) {
    throw std::runtime_error(fmt::format("{} has {}; accepted: one decimal mark throughout, groups of three digits",
                                         quoted(std::string(text)), both ? "point and comma" : "several marks"));
  }
  const bool grouped_only = !both && last_count > 1;
  settle(grouped_only ? otherMark(marks.last) : marks.last, text, line);
  column.decimals = column.decimals || !grouped_only;
}

const char* NumberMarks::normalised(std::string_view field, std::size_t channel, const std::string& name,
                                    std::size_t line) {
  std::string signed_number;
  std::string joined;
  const std::string_view number = withSignJoined(field, signed_number);
  const std::string_view text = withoutGroupMarks(number, joined);
  thousands_ = thousands_ || text.size() < number.size();
  if (text.size() > kLongestNumber) {
    throw std::runtime_error(
        fmt::format("{}: {} is not a number; accepted: a finite number", name, quoted(std::string(text))));
  }
  const bool has_mark = text.find_first_of(".,") != std::string_view::npos;
  last_marked_ = last_may_be_either_ = false;
  const bool is_number = std::all_of(text.begin(), text.end(), [](char c) {
    return isMarkDigit(c) || c == '.' || c == ',' || c == '+' || c == '-' || c == 'e' || c == 'E';
  });
  if (has_mark && is_number) {
    try {
      lookAt(text, channel, line);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("{}: {}", name, error.what()));
    }
  }
  const char told = columns_[channel].told;
  const char decimal = told != '\0' ? told : decimal_ == '\0' ? assumed_ : decimal_;
  char* to = buffer_;
  for (const char c : text) {
    if (is_number && (c == '.' || c == ',') && c != decimal) {
      thousands_ = true;
    } else {
      *to++ = is_number && c == decimal ? '.' : c;
    }
  }
  *to = '\0';
  end_ = to;
  return buffer_;
}

void NumberMarks::see(double value, std::size_t channel) {
  ColumnMarks& column = columns_[channel];
  if (std::isnan(value)) {
    return;
  }
  const int marked = last_marked_ ? 1 : 0;
  column.unmarked = column.unmarked || !last_marked_;
  column.large = column.large || (!last_marked_ && std::abs(value) >= 1000.0);
  if (column.last_marked >= 0 && column.last_marked != marked) {
    column.as_decimals += relativeStep(column.last, value);
    column.as_thousands +=
        relativeStep((column.last_marked == 1 ? 1000.0 : 1.0) * column.last, (marked == 1 ? 1000.0 : 1.0) * value);
  }
  column.last = value;
  column.last_marked = marked;
}

void NumberMarks::requireClear(const std::vector<std::string>& names, bool by_option) const {
  for (std::size_t i = 0; i < columns_.size() && !told_; ++i) {
    const ColumnMarks& column = columns_[i];
    const bool either = column.told == '\0' && column.line > 0 && !column.decimals && column.unmarked && !column.large;
    // The decimal mark of another column decides, unless this column would jump more with it than with the other mark.
    if (either && (decimal_ == '\0' || column.as_thousands < column.as_decimals)) {
      const std::string option = by_option ? optionFor(column, i) : "a file without thousands separators";
      throw RowError(column.line, fmt::format("{}: the mark in '{}' may be a decimal mark or a thousands separator, "
                                              "and no other number shows which; accepted: {}",
                                              names[i], column.text, option));
    }
  }
}

// Returns the option that resolves the ambiguity: for all columns, or for this one if another column's mark is known.
std::string NumberMarks::optionFor(const ColumnMarks& column, std::size_t channel) const {
  const char mark = column.text.find(',') == std::string::npos ? '.' : ',';
  const std::string of = decimal_ == '\0' ? "" : toString(static_cast<Quantity>(channel)) + "=";
  return fmt::format("--decimal {}{} if the {} is a decimal mark, or --decimal {}{} if it separates thousands", of,
                     mark, nameOfMark(mark), of, otherMark(mark));
}

}  // namespace rubber_suspension::log
