// Runs a command: reads its options, prints help, version and errors, and returns the exit status.
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

/// An error of the command line: exit status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum ExitStatus : int { kSuccess = 0, kFailed = 1, kWrongUsage = 2, kDefect = 3 };

/// Returns the version of this package.
std::string version();

/// Prints one line on stderr, without characters of a file's content that could control the terminal.
void printError(const std::string& command, const std::string& message);
void printNote(const std::string& command, const std::string& note);
void printNotes(const std::string& command, const std::vector<std::string>& notes);
void printWarning(const std::string& command, const std::string& warning);

/// Returns the value of a text such as "10 mm" in the unit of the quantity. Throws UsageError that names the option,
/// the text and what is accepted.
double quantityOf(const std::string& option, const std::string& text, const Quantity& quantity);

/// Calls `call`, turning std::invalid_argument into UsageError; `option` precedes the reason.
template <class Call>
auto asUsage(const std::string& option, Call call) {
  try {
    return call();
  } catch (const std::invalid_argument& error) {
    throw UsageError(option + error.what());
  }
}

/// Returns the result of `work`; a terminal shows `what` if it takes long.
template <class Work>
auto during(const std::string& what, Work work) {
  const io::Activity activity(what);
  return work();
}

/// Runs a command: fills the targets of the options, then calls the body, which returns the exit status. Exceptions are
/// printed as one line on stderr; wrong options return 2, all others 1.
int runCommand(int argc, char** argv, const Command& command, const OptionTable& table,
               const std::function<int()>& body);

/// Runs a command whose options are a type with a table, and passes them to the body.
template <class Options, class Body>
int runCommand(int argc, char** argv, const Command& command, const Body& body) {
  Options options;
  return runCommand(argc, argv, command, options.table(), [&] { return body(options); });
}

}  // namespace rubber_suspension::command_line
