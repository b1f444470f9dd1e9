// The reference page of the commands, written from what they print themselves.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::ros_interface {

/// What a command prints with an option such as --help, and its exit status. Commands lie beside the running one.
struct CommandOutput {
  std::string text;
  int status;
};
CommandOutput outputOf(const std::string& command, const std::string& option);

/// Markdown: the --help-all of each command. Throws std::runtime_error that names a command without one.
std::string commandReference(const std::vector<std::string>& commands);

}  // namespace rubber_suspension::ros_interface
