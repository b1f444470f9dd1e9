// The options --limits and --json of commands that compare a simulated force with a measured one.
#pragma once

#include <string>
#include <vector>

#include "command_line/option_table.h"
#include "gap/agreement.h"

namespace rubber_suspension::command_line {

class AgreementOptions {
 public:
  OptionTable table();

  /// Returns the limits. Throws UsageError that names the option, its text and what is accepted.
  gap::AgreementLimits limits() const;

  /// Writes the JSON file if --json is given and a force was compared. Throws std::runtime_error.
  void write(const std::string& component, const std::string& log,
             const std::vector<gap::ComparedForce>& compared) const;

 private:
  std::vector<std::string> limits_;
  std::string json_;
};

}  // namespace rubber_suspension::command_line
