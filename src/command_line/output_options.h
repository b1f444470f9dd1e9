// The options --force and --plot and the check of all outputs, the same for every command that writes files.
#pragma once

#include <string>
#include <vector>

#include "command_line/option_table.h"
#include "io/output_files.h"

namespace rubber_suspension::command_line {

class OutputOptions {
 public:
  /// --force.
  OptionTable table();

  /// To be called before anything is read; see io::checkOutputs. Throws OutputRefused, or UsageError
  /// where --force has nothing to act on; both end in exit status 2.
  void check(const std::vector<io::InputFile>& inputs, const std::vector<io::OutputFile>& outputs) const;

  /// The same of a command that also writes into a folder, so that --force may act there.
  void checkBesideFolder(const std::vector<io::InputFile>& inputs, const std::vector<io::OutputFile>& outputs) const;

 private:
  bool force_ = false;
};

/// The inputs that one option names, for OutputOptions::check.
void addInputs(std::vector<io::InputFile>& inputs, const std::string& option, const std::vector<std::string>& paths);

/// The option --plot of a command that ends in numbers over an axis: "figure of `what` to draw". Another extension than
/// those of figures is refused before any work is done.
Option plotOption(std::string& path, const std::string& what);

}  // namespace rubber_suspension::command_line
