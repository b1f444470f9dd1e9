// The option --force and the check of all outputs, the same for every command that writes files.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "apps/command.h"
#include "io/output_files.h"

namespace rubber_suspension::apps {

class OutputOptions {
 public:
  /// Adds --force; the object has to live as long as the parser.
  void addTo(CLI::App& app) {
    app.add_flag("--force", force_, "replace an existing file of another kind than the command writes, too");
  }

  /// To be called before anything is read; see io::checkOutputs. Throws OutputRefused, or UsageError
  /// where --force has nothing to act on; both end in exit status 2.
  void check(const std::vector<io::InputFile>& inputs, const std::vector<io::OutputFile>& outputs) const {
    if (force_ && std::all_of(outputs.begin(), outputs.end(), [](const auto& output) { return output.path.empty(); })) {
      throw UsageError("--force has no effect without a file to write; accepted: without it");
    }
    checkBesideFolder(inputs, outputs);
  }

  /// The same of a command that also writes into a folder, so that --force may act there.
  void checkBesideFolder(const std::vector<io::InputFile>& inputs, const std::vector<io::OutputFile>& outputs) const {
    io::checkOutputs(inputs, outputs, force_);
  }

 private:
  bool force_ = false;
};

/// The inputs that one option names, for OutputOptions::check.
inline void addInputs(std::vector<io::InputFile>& inputs, const std::string& option,
                      const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    inputs.push_back({option, path});
  }
}

}  // namespace rubber_suspension::apps
