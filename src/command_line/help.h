// Formats the help of a command from its table of options.
#pragma once

#include <string>
#include <vector>

#include "command_line/option_table.h"

namespace rubber_suspension::command_line {

/// An example that can be run as printed. The files of config/ in it are found in the folder of the package.
struct Example {
  std::string purpose;    ///< what the example does, such as "A log without a header"
  std::string arguments;  ///< the part of the call after the name of the command
};

/// The name and purpose of a command.
struct Command {
  std::string name;
  /// Begins with a sentence such as "Simulates ...". Lines "  name  text" form a list. Only --help-all shows the text
  /// after the first empty line.
  std::string description;
  std::vector<Example> examples = {};
};

enum class HelpSize {
  screen,  ///< for --help: the common options, with their help as far as its first semicolon
  all,     ///< for --help-all
};

/// Returns description, usage, arguments, options and examples in lines of at most 100 characters.
std::string helpText(const Command& command, const OptionTable& table, HelpSize size);

/// Formats a number for help and errors: 100000 and 0.01, not 1e+05.
std::string numberText(double number);

}  // namespace rubber_suspension::command_line
