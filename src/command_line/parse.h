// Parses a command line by a table of options.
#pragma once

#include "command_line/help.h"
#include "command_line/option_table.h"

namespace rubber_suspension::command_line {

enum class Request { run, help, help_all, version };

/// Fills the targets of the table. Throws UsageError with one line if the words do not fit the table or its rules; for
/// a misspelt option it names the nearest one.
Request parse(int argc, char** argv, const Command& command, const OptionTable& table);

}  // namespace rubber_suspension::command_line
