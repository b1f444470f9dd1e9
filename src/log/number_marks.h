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

/// Returns "1072.5" for "1 072.5": without the apostrophe or blank before each group of three digits, which is never a
/// decimal mark. Returns other text unchanged. `joined` stores the result if it differs.
std::string_view withoutGroupMarks(std::string_view text, std::string& joined);

/// Returns "+1.5" for "+ 1.5", and other text unchanged. `joined` stores the result if it differs.
std::string_view withSignJoined(std::string_view text, std::string& joined);

/// Thrown if a number contradicts the decimal mark by which earlier ones were read, so that they have to be read again.
struct OtherDecimalMark {
  char decimal;
};

/// Finds the decimal mark of one file. A mark with other than three digits behind it, or behind a 0, is decimal; one
/// that occurs twice in a number, or before the other, is not. requireClear() refuses marks that no number decides.
class NumberMarks {
 public:
  /// `told`: decimal mark given by the user; `found`: that of an earlier reading; '\0': none. `told_of`: those given by
  /// the user for each column that is read.
  NumberMarks(char told, char found, const std::vector<char>& told_of)
      : told_(told != '\0'), decimal_(told != '\0' ? told : found), columns_(told_of.size()) {
    for (std::size_t i = 0; i < told_of.size(); ++i) {
      columns_[i].told = told_of[i];
    }
  }

  /// Returns the number with a decimal point and without thousands separators, ended by a 0; valid until the next
  /// call. Throws std::runtime_error if the marks contradict others, and OtherDecimalMark.
  const char* normalised(std::string_view field, std::size_t channel, const std::string& name, std::size_t line);
  const char* end() const { return end_; }

  /// Registers a field between commas, in which every mark is a point and nothing has to be normalised.
  void seePlain(const char* field, const char* field_end, double value, std::size_t channel, std::size_t line) {
    const ColumnMarks& column = columns_[channel];
    if (!column.decimals && !column.large && !std::isnan(value)) {
      lookAt({field, static_cast<std::size_t>(field_end - field)}, channel, line);
      see(value, channel);
    }
  }

  /// Registers the value of the number that was normalised last.
  void see(double value, std::size_t channel);

  /// Throws RowError if a column has numbers such as 1.072 beside unmarked ones below 1000, and nothing decides whether
  /// that is one or a thousand. `by_option`: the columns are those of a log, in the order of their quantities, and an
  /// option can give their marks.
  void requireClear(const std::vector<std::string>& names, bool by_option) const;

  bool hasDecimalComma() const { return decimal_ == ',' && marked_; }
  bool hasThousands() const { return thousands_; }

 private:
  struct Marks;
  // Evidence from the numbers of one column.
  struct ColumnMarks {
    char told = '\0';       // decimal mark given by the user; '\0': that of the file
    bool decimals = false;  // some marks are certainly decimal
    bool unmarked = false;
    bool large = false;    // an unmarked number of 1000 or more, so that none has thousands separators
    std::size_t line = 0;  // of the first ambiguous number; 0: none
    std::string text;      // the first ambiguous number
    double last = 0.0;
    int last_marked = -1;       // 1, 0; -1: no number yet
    double as_decimals = 0.0;   // sum of relative steps between marked and unmarked numbers, with decimal marks
    double as_thousands = 0.0;  // the same with thousands separators
  };

  std::string optionFor(const ColumnMarks& column, std::size_t channel) const;
  void lookAt(std::string_view text, std::size_t channel, std::size_t line);
  void settle(char decimal, std::string_view text, std::size_t line);

  bool told_ = false;
  char decimal_ = '\0';
  std::size_t decimal_line_ = 0;
  char assumed_ = '\0';  // mark that was read as decimal before a number decided
  bool marked_ = false;
  bool thousands_ = false;
  bool last_may_be_either_ = false;
  bool last_marked_ = false;
  std::vector<ColumnMarks> columns_;
  char buffer_[kLongestNumber + 1] = {};
  const char* end_ = buffer_;
};

}  // namespace rubber_suspension::log
