// Represents the options of a command as data: names, values, targets, and rules for combinations of them. The
// functions in command_line/parse.h parse a command line according to such a table.
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

#include "io/output_files.h"
#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::command_line {

/// The target of an option whose value is a quantity such as "10 mm" or "1 %". A number without a unit is in `unit`.
struct Quantity {
  std::variant<double*, std::optional<double>*, std::vector<double>*> value;  ///< receives the value in `unit`
  std::string unit;                                                           ///< SI unit in the spelling of UDUNITS
  element::Range range = element::Range::positive();
  std::string accepted = {};  ///< what errors state as accepted; empty: derived from the range
};

/// The variable to which the value of an option is assigned. It must outlive the command.
using Target = std::variant<bool*, std::string*, std::vector<std::string>*, double*, int*, std::vector<int>*,
                            std::uint64_t*, Quantity>;

/// The files that a command reads and writes although no option names them, such as the files in a folder.
struct Files {
  std::vector<io::InputFile> inputs;
  std::vector<io::OutputFile> outputs;
};

/// An option, which is one row of the table. A name without dashes makes it a positional argument.
struct Option {
  static constexpr int kAny = std::numeric_limits<int>::max();

  Option(std::string name, bool& given, std::string help);

  /// Makes an option with a value, or with several if the target is a list. The placeholder names the value
  /// ("SECONDS"). The help has no capital and no full stop. The target's value is the default.
  template <class T>
  Option(std::string name_, T& target_, std::string placeholder_, std::string help_)
      : Option(std::move(name_), Target(&target_), std::move(placeholder_), std::move(help_)) {}
  Option(std::string name, Target target, std::string placeholder, std::string help);

  Option& required() { return is_required = true, *this; }

  /// Omits the option from --help, which should fit on a screen. --help-all shows it.
  Option& rare() { return is_rare = true, *this; }

  /// Omits the option from all help texts.
  Option& hidden() { return is_hidden = true, *this; }

  /// Restricts the value to numbers from `lowest` to `highest`.
  Option& within(double lowest, double highest) { return bounds = {lowest, highest}, *this; }

  /// Restricts the value to these words.
  Option& oneOf(std::vector<std::string> all) { return words = std::move(all), *this; }

  /// Sets how many values the option takes. By default, a list takes any number of values.
  Option& values(int least, int most) { return least_values = least, most_values = most, *this; }

  /// Sets the text that the help shows as the default of a quantity.
  Option& defaultText(std::string text) { return default_text = std::move(text), *this; }

  /// Sets a function that returns the error in a value, or "" if the value is valid.
  Option& checkedBy(std::function<std::string(const std::string&)> check) { return problem = std::move(check), *this; }

  /// Declares the value as a file to read. Before the command begins, it is checked that no file is both read and
  /// written, and that no file of another kind is overwritten unless --force is given.
  Option& reads() { return is_input = true, *this; }

  /// Declares the value as a log to read. No log may occur twice in all options of this kind.
  Option& readsEachOnce() { return is_each_once = true, reads(); }

  /// Declares the value as a file to write. The command then has the option --force.
  Option& writes(io::FileKind written) { return kind = written, *this; }

  /// Sets a function that returns the files which an option implies. It is called after parsing.
  Option& standsFor(std::function<Files()> all) { return files = std::move(all), *this; }

  bool isArgument() const { return name.compare(0, 1, "-") != 0; }
  bool isFlag() const { return std::holds_alternative<bool*>(target); }

  std::string name;
  Target target;
  std::string placeholder;
  std::string help;
  bool is_required = false;
  bool is_rare = false;
  bool is_hidden = false;
  std::optional<std::pair<double, double>> bounds;
  std::vector<std::string> words;
  int least_values = 1;
  int most_values = 1;       ///< by default kAny for a list
  std::string default_text;  ///< empty: the help shows no default
  std::function<std::string(const std::string&)> problem;
  bool is_input = false;
  bool is_each_once = false;
  std::optional<io::FileKind> kind;
  std::function<Files()> files;
};

/// A rule for combinations of options. The condition "--plan" means that this option is given, the condition "--forces
/// topics" that this option has this value.
struct Rule {
  enum class Kind {
    needs,     ///< the options have no effect unless one of the conditions is true
    excludes,  ///< the options have no effect if one of the conditions is true
    one_of,    ///< exactly one of the options must be given
  };
  Kind kind;
  std::vector<std::string> options;
  std::vector<std::string> conditions;
};

/// The options of a command in the order of its help. Tables of options that several commands share can be joined.
class OptionTable {
 public:
  OptionTable(Option option) : options_{std::move(option)} {}  // NOLINT: converts an option to a table of one row
  OptionTable(std::initializer_list<OptionTable> parts);

  OptionTable& needs(std::vector<std::string> options, std::vector<std::string> conditions) {
    return add({Rule::Kind::needs, std::move(options), std::move(conditions)});
  }
  OptionTable& excludes(std::vector<std::string> options, std::vector<std::string> conditions) {
    return add({Rule::Kind::excludes, std::move(options), std::move(conditions)});
  }
  OptionTable& oneOf(std::vector<std::string> options) { return add({Rule::Kind::one_of, std::move(options), {}}); }

  const std::vector<Option>& options() const { return options_; }
  const std::vector<Rule>& rules() const { return rules_; }

 private:
  OptionTable& add(Rule rule);

  std::vector<Option> options_;
  std::vector<Rule> rules_;
};

}  // namespace rubber_suspension::command_line
