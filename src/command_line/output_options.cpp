// The options --force and --plot.
#include "command_line/output_options.h"

#include <algorithm>

#include "command_line/command.h"
#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::command_line {

OptionTable OutputOptions::table() {
  return Option("--force", force_, "replace an existing file of another kind than the command writes, too");
}

void OutputOptions::check(const std::vector<io::InputFile>& inputs, const std::vector<io::OutputFile>& outputs) const {
  if (force_ && std::all_of(outputs.begin(), outputs.end(), [](const auto& output) { return output.path.empty(); })) {
    throw UsageError("--force has no effect without a file to write; accepted: without it");
  }
  checkBesideFolder(inputs, outputs);
}

void OutputOptions::checkBesideFolder(const std::vector<io::InputFile>& inputs,
                                      const std::vector<io::OutputFile>& outputs) const {
  io::checkOutputs(inputs, outputs, force_);
}

void addInputs(std::vector<io::InputFile>& inputs, const std::string& option, const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    inputs.push_back({option, path});
  }
}

Option plotOption(std::string& path, const std::string& what) {
  return Option("--plot", path, "FILE", "figure of " + what + " to draw, .svg or .png")
      .checkedBy([](const std::string& name) {
        return name.empty() || io::isFigurePath(name) ? "" : name + "; accepted: a name that ends in .svg or .png";
      });
}

}  // namespace rubber_suspension::command_line
