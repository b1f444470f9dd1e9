// Warns of inputs that are valid but suspicious.
#include "command_line/warnings.h"

#include "command_line/command.h"
#include "rubber_suspension/estimation/notes.h"

namespace rubber_suspension::command_line {

void warnOf(const std::string& command, const io::ComponentDescription& description) {
  for (const std::string& warning : estimation::specificationWarnings(description.written())) {
    printWarning(command, description.name + ": " + warning);
  }
}

void warnOf(const std::string& command, const std::string& path, const std::optional<std::string>& odd) {
  if (odd) {
    printWarning(command, path + ": " + *odd);
  }
}

void warnOfTemperature(const std::string& command, const std::string& path, bool has_temperature,
                       const io::ComponentDescription& description) {
  if (!has_temperature && description.makeComponent().shiftsWithTemperature()) {
    printWarning(command, path + ": the log has no column temperature_degC; " + description.name +
                              " is simulated at its reference temperature");
  }
}

}  // namespace rubber_suspension::command_line
