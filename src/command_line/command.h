// The frame of every command: its options read by their table, --help, --version, exit status, errors in one line.
#pragma once

#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "command_line/help.h"
#include "command_line/option_table.h"
#include "io/progress.h"

namespace rubber_suspension::command_line {

/// Options that are each right, but not together: exit status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum ExitStatus : int { kSuccess = 0, kFailed = 1, kWrongUsage = 2, kDefect = 3 };

/// Version of this package.
std::string version();

/// One line on stderr, in which nothing of a file's content can steer the terminal.
void printError(const std::string& command, const std::string& message);
void printNote(const std::string& command, const std::string& note);
void printNotes(const std::string& command, const std::vector<std::string>& notes);
void printWarning(const std::string& command, const std::string& warning);

/// The value of a text such as "10 mm" in the unit of the quantity. Throws UsageError that names option, text and what
/// is accepted.
double quantityOf(const std::string& option, const std::string& text, const Quantity& quantity);

/// Calls it. Arguments that it refuses were wrong on the command line; `option` is put before the reason.
template <class Call>
auto asUsage(const std::string& option, Call call) {
  try {
    return call();
  } catch (const std::invalid_argument& error) {
    throw UsageError(option + error.what());
  }
}

/// The result of work of which a terminal is told while it takes long.
template <class Work>
auto during(const std::string& what, Work work) {
  const io::Activity activity(what);
  return work();
}

/// Run a command: fill what the options of the table point to, then call the body, which returns the exit status. An
/// exception of the body is printed as one line on stderr and ends in exit status 1, wrong options in 2.
int runCommand(int argc, char** argv, const Command& command, const OptionTable& table,
               const std::function<int()>& body);

/// Passes options that have a table to the body.
template <class Options, class Body>
int runCommand(int argc, char** argv, const Command& command, const Body& body) {
  Options options;
  return runCommand(argc, argv, command, options.table(), [&] { return body(options); });
}

}  // namespace rubber_suspension::command_line
