// The options of a command as data: what each is called, what it takes and fills, and which of them go together. No
// parser: command_line/command.h reads a command line by such a table.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::command_line {

/// A value with its unit, as "10 mm" or "1 %"; a number alone is in `unit`.
struct Quantity {
  std::variant<double*, std::optional<double>*, std::vector<double>*> value;  ///< in `unit`
  std::string unit;                                                           ///< SI, in UDUNITS spelling
  element::Range range = element::Range::positive();
  std::string accepted = {};  ///< for errors; by itself what describes the range
};

/// What an option fills: a flag, text, a number, or a list of these. It has to live as long as the command.
using Target = std::variant<bool*, std::string*, std::vector<std::string>*, double*, int*, std::vector<int>*,
                            std::uint64_t*, Quantity>;

/// One row of the table. A name without dashes is an argument, told by its place.
struct Option {
  /// A flag.
  Option(std::string name, bool& given, std::string help);

  /// An option with a value, or several where the target is a list. The placeholder says what it takes ("SECONDS");
  /// the help has neither capital nor full stop. What the target holds is the default, shown where it is admissible.
  template <class T>
  Option(std::string name_, T& target_, std::string placeholder_, std::string help_)
      : Option(std::move(name_), Target(&target_), std::move(placeholder_), std::move(help_)) {}
  Option(std::string name, Target target, std::string placeholder, std::string help);

  Option& required();
  Option& hidden();  ///< accepted, and not in any help

  /// A number from `lowest` to `highest`.
  Option& within(double lowest, double highest);

  /// One of these words.
  Option& oneOf(std::vector<std::string> words);

  /// So many values; a list takes any number by itself.
  Option& values(int least, int most);

  /// Default of a quantity, as a user would write it.
  Option& defaultText(std::string text);

  /// What is wrong with a value of this text, empty where nothing is.
  Option& checkedBy(std::function<std::string(const std::string&)> problem);

  bool isArgument() const { return name.compare(0, 1, "-") != 0; }
  bool isFlag() const { return std::holds_alternative<bool*>(target); }

  std::string name;
  Target target;
  std::string placeholder;
  std::string help;
  bool is_required = false;
  bool is_hidden = false;
  std::optional<std::pair<double, double>> bounds;
  std::vector<std::string> words;
  static constexpr int kAny = std::numeric_limits<int>::max();
  int least_values = 1;
  int most_values = 1;       ///< kAny by itself for a list
  std::string default_text;  ///< empty: none to be shown
  std::function<std::string(const std::string&)> problem;
};

/// Which options go with which. A condition is an option that is given, as "--plan", or an option and its value, as
/// "--forces topics".
struct Rule {
  enum class Kind {
    needs,     ///< the options have no effect unless one of the conditions holds
    excludes,  ///< the options have no effect where one of the conditions holds
    one_of,    ///< one of the options has to be given, and no other of them
  };
  Kind kind;
  std::vector<std::string> options;
  std::vector<std::string> conditions;
};

/// The options of a command in the order of its help. Options that several commands share are tables that are joined.
class OptionTable {
 public:
  OptionTable(Option option) : options_{std::move(option)} {}  // NOLINT: a row is a table
  OptionTable(std::initializer_list<OptionTable> parts);

  OptionTable& needs(std::vector<std::string> options, std::vector<std::string> conditions);
  OptionTable& excludes(std::vector<std::string> options, std::vector<std::string> conditions);
  OptionTable& oneOf(std::vector<std::string> options);

  const std::vector<Option>& options() const { return options_; }
  const std::vector<Rule>& rules() const { return rules_; }

 private:
  std::vector<Option> options_;
  std::vector<Rule> rules_;
};

}  // namespace rubber_suspension::command_line
