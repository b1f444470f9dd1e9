// Runs a command: parses its options, prints help, version and errors, and returns the exit status.
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

/// An error in the command line, which results in exit status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum ExitStatus : int { kSuccess = 0, kFailed = 1, kWrongUsage = 2, kDefect = 3 };

std::string version();

/// Prints one line on stderr. Characters that could control the terminal are replaced.
void printError(const std::string& command, const std::string& message);
void printNote(const std::string& command, const std::string& note);
void printNotes(const std::string& command, const std::vector<std::string>& notes);
void printWarning(const std::string& command, const std::string& warning);

/// Converts a text such as "10 mm" to the unit of the quantity. Throws UsageError that names option and text.
double quantityOf(const std::string& option, const std::string& text, const Quantity& quantity);

/// Returns the result of `call`, and converts std::invalid_argument to UsageError with the text `option` in front.
template <class Call>
auto asUsage(const std::string& option, Call call) {
  try {
    return call();
  } catch (const std::invalid_argument& error) {
    throw UsageError(option + error.what());
  }
}

/// Returns the result of `work`. If it takes long, `what` is shown on a terminal.
template <class Work>
auto during(const std::string& what, Work work) {
  const io::Activity activity(what);
  return work();
}

/// Runs a command: assigns the options to their targets and calls the body, which returns the exit status. Exceptions
/// are printed as one line. The status is 2 for wrong options and refused output files, 1 for other exceptions.
int runCommand(int argc, char** argv, const Command& command, const OptionTable& table,
               const std::function<int()>& body);

/// Runs a command whose options are an object of type Options with a function table(). The body receives this object.
template <class Options, class Body>
int runCommand(int argc, char** argv, const Command& command, const Body& body) {
  Options options;
  return runCommand(argc, argv, command, options.table(), [&] { return body(options); });
}

}  // namespace rubber_suspension::command_line
