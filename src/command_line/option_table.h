// The options of a command as data: their names, values, targets, and rules for combinations of them.
// command_line/parse.h parses a command line by such a table.
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

/// A value with its unit, as "10 mm" or "1 %"; a number alone is in `unit`.
struct Quantity {
  std::variant<double*, std::optional<double>*, std::vector<double>*> value;  ///< in `unit`
  std::string unit;                                                           ///< SI, in UDUNITS spelling
  element::Range range = element::Range::positive();
  std::string accepted = {};  ///< for errors; empty: follows from the range
};

/// The variable that an option fills: a flag, text, a number, or a list of these. It must outlive the command.
using Target = std::variant<bool*, std::string*, std::vector<std::string>*, double*, int*, std::vector<int>*,
                            std::uint64_t*, Quantity>;

/// Files that a command reads and writes besides those that its options name, such as those in a folder.
struct Files {
  std::vector<io::InputFile> inputs;
  std::vector<io::OutputFile> outputs;
};

/// One row of the table. A name without dashes is a positional argument.
struct Option {
  static constexpr int kAny = std::numeric_limits<int>::max();

  /// Makes a flag.
  Option(std::string name, bool& given, std::string help);

  /// Makes an option with a value, or several if the target is a list. The placeholder names the value ("SECONDS"); the
  /// help has neither capital nor full stop. The value of the target is the default, shown if it is admissible.
  template <class T>
  Option(std::string name_, T& target_, std::string placeholder_, std::string help_)
      : Option(std::move(name_), Target(&target_), std::move(placeholder_), std::move(help_)) {}
  Option(std::string name, Target target, std::string placeholder, std::string help);

  Option& required() { return is_required = true, *this; }

  /// Omits the option from --help, which is one screen; --help-all shows it.
  Option& rare() { return is_rare = true, *this; }

  /// Makes the option accepted but not shown in any help.
  Option& hidden() { return is_hidden = true, *this; }

  /// Accepts numbers from `lowest` to `highest`.
  Option& within(double lowest, double highest) { return bounds = {lowest, highest}, *this; }

  /// Accepts only these words.
  Option& oneOf(std::vector<std::string> all) { return words = std::move(all), *this; }

  /// Sets the number of values; by default a list accepts any number.
  Option& values(int least, int most) { return least_values = least, most_values = most, *this; }

  /// Sets the default of a quantity for the help, as a user would write it.
  Option& defaultText(std::string text) { return default_text = std::move(text), *this; }

  /// Sets a check, which returns the error of a text, or "" if it is valid.
  Option& checkedBy(std::function<std::string(const std::string&)> check) { return problem = std::move(check), *this; }

  /// Marks names of files to read. Before the command begins, it is checked that no file is both read and written and
  /// that no file of another kind is replaced without --force.
  Option& reads() { return is_input = true, *this; }

  /// Marks names of logs to read, none of which may occur twice in all such options together.
  Option& readsEachOnce() { return is_each_once = true, reads(); }

  /// Marks names of files to write. The command then has the option --force.
  Option& writes(io::FileKind written) { return kind = written, *this; }

  /// Sets a function, called after parsing, that returns the files which an option implies, such as those of a folder.
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
  int most_values = 1;       ///< kAny by default for a list
  std::string default_text;  ///< empty: no default is shown
  std::function<std::string(const std::string&)> problem;
  bool is_input = false;
  bool is_each_once = false;
  std::optional<io::FileKind> kind;
  std::function<Files()> files;
};

/// Rule for combinations of options. A condition is a given option, such as "--plan", or an option and its value, such
/// as "--forces topics".
struct Rule {
  enum class Kind {
    needs,     ///< the options have no effect unless one of the conditions holds
    excludes,  ///< the options have no effect if one of the conditions holds
    one_of,    ///< exactly one of the options has to be given
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
