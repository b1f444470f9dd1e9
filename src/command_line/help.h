// The help of a command, from its table of options.
#pragma once

#include <string>
#include <vector>

#include "command_line/option_table.h"

namespace rubber_suspension::command_line {

/// What a command is called and does.
struct Command {
  std::string name;
  std::string description;  ///< begins with a sentence "Simulates ..."; lines that begin with blanks stay as they are
};

/// Lines of a terminal's width: description, usage, arguments and options, the range and default of a value behind its
/// meaning.
std::string helpText(const Command& command, const OptionTable& table);

/// How many decimal places a number of a help or an error takes: 100000 and 0.01, not 1e+05.
std::string numberText(double number);

}  // namespace rubber_suspension::command_line
