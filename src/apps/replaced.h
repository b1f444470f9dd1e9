// A command that `export` replaces: it says so and becomes that command.
#pragma once

#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "command_line/command.h"

namespace rubber_suspension::apps {

/// Runs `export` beside this program with these arguments. Returns only where it cannot: the exit status.
inline int becomeExport(const std::string& name, std::vector<std::string> arguments) {
  command_line::printNote(name, "goes with the next version; accepted from now on: export --format");
  const std::string program = (std::filesystem::read_symlink("/proc/self/exe").parent_path() / "export").string();
  arguments.insert(arguments.begin(), program);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) {
    pointers.push_back(argument.data());
  }
  pointers.push_back(nullptr);
  execv(program.c_str(), pointers.data());
  command_line::printError(name, program + ": cannot be started: " + std::strerror(errno));
  return command_line::kFailed;
}

}  // namespace rubber_suspension::apps
