// Decides which of point and comma is the decimal mark of a text file, and which separates thousands.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rubber_suspension::log {

/// Largest number of characters in a number.
constexpr std::size_t kLongestNumber = 127;

/// Returns the number without the apostrophes or blanks between groups of three digits, "1072.5" for "1 072.5". Returns
/// other text unchanged. `joined` provides the storage for a changed number.
std::string_view withoutGroupMarks(std::string_view text, std::string& joined);

/// Returns "+1.5" for "+ 1.5", and other text unchanged. `joined` provides the storage for a changed number.
std::string_view withSignJoined(std::string_view text, std::string& joined);

/// Thrown if a number contradicts the decimal mark that was assumed before. The file has to be read again.
struct OtherDecimalMark {
  char decimal;
};

/// Determines the decimal mark of a file from its numbers. A mark is decimal unless exactly three digits follow it, and
/// also if the number begins with 0. A mark separates thousands if it occurs twice in a number or precedes the other
/// mark. requireClear() refuses a column whose numbers decide neither.
class NumberMarks {
 public:
  /// `told` is the decimal mark that the user gave, `found` the one that an earlier pass over the file found; '\0'
  /// stands for none. `told_of` are the marks that the user gave for each column.
  NumberMarks(char told, char found, const std::vector<char>& told_of)
      : told_(told != '\0'), decimal_(told != '\0' ? told : found), columns_(told_of.size()) {
    for (std::size_t i = 0; i < told_of.size(); ++i) {
      columns_[i].told = told_of[i];
    }
  }

  /// Returns the number with a decimal point, without thousands separators and null-terminated. It is valid until the
  /// next call. Throws std::runtime_error or OtherDecimalMark if a mark contradicts an earlier one.
  const char* normalised(std::string_view field, std::size_t channel, const std::string& name, std::size_t line);
  const char* end() const { return end_; }

  /// Registers a field of a row with commas as separators, in which every mark is a point.
  void seePlain(const char* field, const char* field_end, double value, std::size_t channel, std::size_t line) {
    const ColumnMarks& column = columns_[channel];
    if (!column.decimals && !column.large && !std::isnan(value)) {
      lookAt({field, static_cast<std::size_t>(field_end - field)}, channel, line);
      see(value, channel);
    }
  }

  /// Registers the value of the number that normalised() returned last.
  void see(double value, std::size_t channel);

  /// Throws RowError if a column contains numbers such as 1.072 and unmarked numbers below 1000, and nothing decides
  /// whether 1.072 means 1072. If `by_option` is true, the columns are those of a log in the order of kQuantities, and
  /// the error suggests the option that gives their marks.
  void requireClear(const std::vector<std::string>& names, bool by_option) const;

  bool hasDecimalComma() const { return decimal_ == ',' && marked_; }
  bool hasThousands() const { return thousands_; }

 private:
  struct Marks;
  // The evidence on the marks from the numbers of one column.
  struct ColumnMarks {
    char told = '\0';       // decimal mark that the user gave for the column; '\0': none
    bool decimals = false;  // true if at least one mark is certainly decimal
    bool unmarked = false;
    bool large = false;    // true after an unmarked number of 1000 or more, which excludes thousands separators
    std::size_t line = 0;  // line of the first ambiguous number; 0: none
    std::string text;      // the first ambiguous number
    double last = 0.0;
    int last_marked = -1;       // 1 if the last number had a mark, 0 if not, -1 before the first
    double as_decimals = 0.0;   // sum of the relative steps between marked and unmarked numbers if the mark is decimal
    double as_thousands = 0.0;  // the same sum if the mark separates thousands
  };

  std::string optionFor(const ColumnMarks& column, std::size_t channel) const;
  void lookAt(std::string_view text, std::size_t channel, std::size_t line);
  void settle(char decimal, std::string_view text, std::size_t line);

  bool told_ = false;
  char decimal_ = '\0';
  std::size_t decimal_line_ = 0;
  char assumed_ = '\0';  // mark that is taken as decimal as long as no number decides
  bool marked_ = false;
  bool thousands_ = false;
  bool last_may_be_either_ = false;
  bool last_marked_ = false;
  std::vector<ColumnMarks> columns_;
  char buffer_[kLongestNumber + 1] = {};
  const char* end_ = buffer_;
};

}  // namespace rubber_suspension::log
