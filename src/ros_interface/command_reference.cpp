// The reference page of the commands.
#include "ros_interface/command_reference.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <stdexcept>

#include "ros_interface/child_process.h"

namespace rubber_suspension::ros_interface {

CommandOutput outputOf(const std::string& command, const std::string& option) {
  const std::string line = fmt::format("'{}' {} 2>/dev/null </dev/null", siblingProgram(command), option);
  std::FILE* pipe = popen(line.c_str(), "r");
  if (pipe == nullptr) {
    throw std::runtime_error(command + " cannot be started");
  }
  CommandOutput output{"", -1};
  std::array<char, 4096> buffer{};
  for (std::size_t count = 0; (count = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
    output.text.append(buffer.data(), count);
  }
  const int status = pclose(pipe);
  output.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return output;
}

std::string commandReference(const std::vector<std::string>& commands) {
  std::string text =
      "# Reference of the commands\n\n"
      "Written by the command `reference` from what they print: `rosrun rubber_suspension COMMAND --help-all`. All "
      "exit "
      "with\n0, with 1 where the data could not be used, with 2 on wrong options; errors are one line on stderr.\n";
  for (const std::string& command : commands) {
    const CommandOutput help = outputOf(command, "--help-all");
    if (help.status != 0 || help.text.empty()) {
      throw std::runtime_error(fmt::format("{} --help-all: exit status {}", command, help.status));
    }
    std::string body = help.text;
    while (!body.empty() && body.back() == '\n') {
      body.pop_back();
    }
    text += fmt::format("\n## {}\n\n```\n{}\n```\n", command, body);
  }
  return text;
}

}  // namespace rubber_suspension::ros_interface
