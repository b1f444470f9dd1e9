// The frame of every command: its options read by their table, --help, --version, exit status, errors in one line.
#pragma once

#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>

#include "command_line/help.h"
#include "command_line/option_table.h"

namespace rubber_suspension::command_line {

/// Options that are each right, but not together: exit status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum ExitStatus : int { kSuccess = 0, kFailed = 1, kWrongUsage = 2 };

/// Of this package.
std::string version();

/// One line on stderr, in which nothing of a file's content can steer the terminal.
void printError(const std::string& command, const std::string& message);
void printNote(const std::string& command, const std::string& note);
void printWarning(const std::string& command, const std::string& warning);

/// The value of a text such as "10 mm" in the unit of the quantity. Throws UsageError that names option, text and what
/// is accepted.
double quantityOf(const std::string& option, const std::string& text, const Quantity& quantity);

/// Run a command: fill what the options of the table point to, then call the body, which returns the exit status. An
/// exception of the body is printed as one line on stderr and ends in exit status 1, wrong options in 2.
int runCommand(int argc, char** argv, const Command& command, const OptionTable& table,
               const std::function<int()>& body);

}  // namespace rubber_suspension::command_line
