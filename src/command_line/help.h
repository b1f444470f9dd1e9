// The help of a command, from its table of options.
#pragma once

#include <string>
#include <vector>

#include "command_line/option_table.h"

namespace rubber_suspension::command_line {

/// A call that works as printed, in the folder of the package where it names files of config/.
struct Example {
  std::string purpose;    ///< as "A log without a header"
  std::string arguments;  ///< behind the name of the command
};

/// The name and purpose of a command.
struct Command {
  std::string name;
  /// Begins with a sentence "Simulates ..."; lines that begin with blanks stay as they are. Text after the first empty
  /// line is for --help-all.
  std::string description;
  std::vector<Example> examples = {};
};

enum class HelpSize {
  screen,  ///< --help: the common options, as far as the first semicolon of their help
  all,     ///< --help-all
};

/// Lines of a terminal's width: description, usage, arguments and options, the range and default of a value behind its
/// meaning, examples.
std::string helpText(const Command& command, const OptionTable& table, HelpSize size);

/// Number as text of a help or an error: 100000 and 0.01, not 1e+05.
std::string numberText(double number);

}  // namespace rubber_suspension::command_line
