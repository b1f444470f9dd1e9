// Points and commas in the numbers of a text: which of them is the decimal mark, and which stands between thousands.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rubber_suspension::log {

/// Characters of the longest text that may be a number.
constexpr std::size_t kLongestNumber = 127;

/// "1 072.5" as "1072.5": an apostrophe or a blank before each group of three digits, which is never a decimal mark.
/// Any other text as it is. The result is kept in `joined` where it is another one.
std::string_view withoutGroupMarks(std::string_view text, std::string& joined);

/// "+ 1.5" as "+1.5": a sign that stands apart. Any other text as it is; the result is kept in `joined` where it is
/// another one.
std::string_view withSignJoined(std::string_view text, std::string& joined);

/// Thrown where numbers have been read with another decimal mark than a later one tells: to be read again.
struct OtherDecimalMark {
  char decimal;
};

/// The marks of one file. A mark with other than three digits behind it, or behind a 0, is a decimal one; one that
/// stands twice in a number, or before the other, is not. What no number of the file tells is left open: see
/// requireClear().
class NumberMarks {
 public:
  /// `told`: by the user; `found`: when the file was read before; '\0': neither.
  /// `told_of`: by the user of each column that is read.
  NumberMarks(char told, char found, const std::vector<char>& told_of)
      : told_(told != '\0'), decimal_(told != '\0' ? told : found), columns_(told_of.size()) {
    for (std::size_t i = 0; i < told_of.size(); ++i) {
      columns_[i].told = told_of[i];
    }
  }

  /// The number with a decimal point and without marks between thousands, ended by a 0; valid until the next call.
  /// Throws std::runtime_error where the marks contradict others, and OtherDecimalMark.
  const char* normalised(std::string_view field, std::size_t channel, const std::string& name, std::size_t line);
  const char* end() const { return end_; }

  /// Notes a field between commas, in which every mark is a point and nothing has to be normalised.
  void seePlain(const char* field, const char* field_end, double value, std::size_t channel, std::size_t line) {
    const ColumnMarks& column = columns_[channel];
    if (!column.decimals && !column.large && !std::isnan(value)) {
      lookAt({field, static_cast<std::size_t>(field_end - field)}, channel, line);
      see(value, channel);
    }
  }

  /// The value of the number that was normalised last.
  void see(double value, std::size_t channel);

  /// Throws RowError where a column has numbers such as 1.072 beside unmarked ones below 1000, and nothing tells
  /// whether that is one or a thousand. `by_option`: columns are those of a log, in the order of their quantities,
  /// whose marks an option tells.
  void requireClear(const std::vector<std::string>& names, bool by_option) const;

  bool hasDecimalComma() const { return decimal_ == ',' && marked_; }
  bool hasThousands() const { return thousands_; }

 private:
  struct Marks;
  // All that is known of the numbers of one column.
  struct ColumnMarks {
    char told = '\0';       // its decimal mark; '\0': that of the file
    bool decimals = false;  // some that can be nothing else, or are told
    bool unmarked = false;
    bool large = false;    // unmarked ones from 1000 on: then none has marks between thousands
    std::size_t line = 0;  // of the first that may be either; 0: none
    std::string text;      // that one
    double last = 0.0;
    int last_marked = -1;       // 1, 0; -1: no number yet
    double as_decimals = 0.0;   // size of the steps between marked and unmarked numbers, relative, read so
    double as_thousands = 0.0;  // and so
  };

  std::string optionFor(const ColumnMarks& column, std::size_t channel) const;
  void lookAt(std::string_view text, std::size_t channel, std::size_t line);
  void settle(char decimal, std::string_view text, std::size_t line);

  bool told_ = false;
  char decimal_ = '\0';
  std::size_t decimal_line_ = 0;
  char assumed_ = '\0';  // mark that was read as decimal while nothing told
  bool marked_ = false;
  bool thousands_ = false;
  bool last_may_be_either_ = false;
  bool last_marked_ = false;
  std::vector<ColumnMarks> columns_;
  char buffer_[kLongestNumber + 1] = {};
  const char* end_ = buffer_;
};

}  // namespace rubber_suspension::log
