// Scripts of the package, each of which runs in a separate process.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::io {

struct ScriptResult {
  bool succeeded = false;
  std::string last_error;  ///< the last line on its standard error
};

/// Runs a script of the package with arguments and a text on its standard input, and waits for its end. Throws
/// std::runtime_error if the script cannot be run.
ScriptResult runScript(const std::string& name, const std::vector<std::string>& arguments, const std::string& input);

}  // namespace rubber_suspension::io
