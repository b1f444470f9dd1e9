// The commands of the package, as CMake lists them.
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace rubber_suspension::command_line {

inline std::vector<std::string> commandNames() {
  std::istringstream words(RUBBER_SUSPENSION_COMMANDS);
  std::vector<std::string> names;
  for (std::string name; words >> name;) {
    names.push_back(name);
  }
  return names;
}

}  // namespace rubber_suspension::command_line
