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

#include "io/output_files.h"
#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::command_line {

/// A value with its unit, as "10 mm" or "1 %"; a number alone is in `unit`.
struct Quantity {
  std::variant<double*, std::optional<double>*, std::vector<double>*> value;  ///< in `unit`
  std::string unit;                                                           ///< SI, in UDUNITS spelling
  element::Range range = element::Range::positive();
  std::string accepted = {};  ///< for errors; by itself what describes the range
};

/// The variable that an option fills: a flag, text, a number, or a list of these. It has to live as long as the
/// command.
using Target = std::variant<bool*, std::string*, std::vector<std::string>*, double*, int*, std::vector<int>*,
                            std::uint64_t*, Quantity>;

/// Files that a command reads and writes besides those that its options name, such as those in a folder.
struct Files {
  std::vector<io::InputFile> inputs;
  std::vector<io::OutputFile> outputs;
};

/// One row of the table. A name without dashes is an argument, told by its place.
struct Option {
  static constexpr int kAny = std::numeric_limits<int>::max();

  /// A flag.
  Option(std::string name, bool& given, std::string help);

  /// An option with a value, or several where the target is a list. The placeholder says what it takes ("SECONDS"); the
  /// help has neither capital nor full stop. The value of the target is the default, shown if it is admissible.
  template <class T>
  Option(std::string name_, T& target_, std::string placeholder_, std::string help_)
      : Option(std::move(name_), Target(&target_), std::move(placeholder_), std::move(help_)) {}
  Option(std::string name, Target target, std::string placeholder, std::string help);

  Option& required() { return is_required = true, *this; }

  /// Left out of --help, which is one screen; in --help-all.
  Option& rare() { return is_rare = true, *this; }

  /// Makes the option accepted but not shown in any help.
  Option& hidden() { return is_hidden = true, *this; }

  /// A number from `lowest` to `highest`.
  Option& within(double lowest, double highest) { return bounds = {lowest, highest}, *this; }

  /// One of these words.
  Option& oneOf(std::vector<std::string> all) { return words = std::move(all), *this; }

  /// So many values; a list takes any number by itself.
  Option& values(int least, int most) { return least_values = least, most_values = most, *this; }

  /// Default of a quantity, as a user would write it.
  Option& defaultText(std::string text) { return default_text = std::move(text), *this; }

  /// The error of a value of this text, empty where there is none.
  Option& checkedBy(std::function<std::string(const std::string&)> check) { return problem = std::move(check), *this; }

  /// A file, or several. No file is written that is also read, nor, without --force, one that is of another kind:
  /// checked before the command does anything. A command that writes has the option --force.
  Option& reads() { return is_input = true, *this; }

  /// Logs, of which none may stand twice in all such options together.
  Option& readsEachOnce() { return is_each_once = true, reads(); }

  /// Files that are written.
  Option& writes(io::FileKind written) { return kind = written, *this; }

  /// A folder, or the like, with the files that it stands for; asked once all options are read.
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
  int most_values = 1;       ///< kAny by itself for a list
  std::string default_text;  ///< empty: none to be shown
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
