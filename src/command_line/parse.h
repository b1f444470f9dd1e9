// From the words of a command line to what a table of options points to.
#pragma once

#include "command_line/help.h"
#include "command_line/option_table.h"

namespace rubber_suspension::command_line {

/// The request of a command line.
enum class Request { run, help, help_all, version };

/// Fills the targets of the table. Throws UsageError, in one line, where the words do not fit the table or its rules;
/// a misspelt option comes with the one that was probably meant.
Request parse(int argc, char** argv, const Command& command, const OptionTable& table);

}  // namespace rubber_suspension::command_line
