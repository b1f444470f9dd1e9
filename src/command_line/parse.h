// Parses a command line according to a table of options.
#pragma once

#include "command_line/help.h"
#include "command_line/option_table.h"

namespace rubber_suspension::command_line {

enum class Request { run, help, help_all, version };

/// Assigns the values in a command line to the targets of the table. Throws UsageError with one line if an argument
/// violates the table or its rules. The error for a misspelt option suggests the most similar one.
Request parse(int argc, char** argv, const Command& command, const OptionTable& table);

}  // namespace rubber_suspension::command_line
