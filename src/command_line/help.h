// The help of a command, from its table of options.
#pragma once

#include <string>
#include <vector>

#include "command_line/option_table.h"

namespace rubber_suspension::command_line {

/// A call that works as printed; files of config/ are found from the folder of the package.
struct Example {
  std::string purpose;    ///< such as "A log without a header"
  std::string arguments;  ///< text after the name of the command
};

/// The name and purpose of a command.
struct Command {
  std::string name;
  /// Begins with a sentence "Simulates ...". Lines "  name  text" form a list. Text after the first empty line is for
  /// --help-all.
  std::string description;
  std::vector<Example> examples = {};
};

enum class HelpSize {
  screen,  ///< --help: the common options, as far as the first semicolon of their help
  all,     ///< --help-all
};

/// Returns description, usage, arguments and options with their ranges and defaults, and examples, in lines of at most
/// 100 characters.
std::string helpText(const Command& command, const OptionTable& table, HelpSize size);

/// Returns a number as text for help and errors: 100000 and 0.01, not 1e+05.
std::string numberText(double number);

}  // namespace rubber_suspension::command_line
