// What is legal and odd in what a command was given, one line each on stderr: the same words for every command.
#pragma once

#include <iostream>
#include <optional>
#include <string>

#include "gap/odd_motion.h"
#include "log/text.h"
#include "rubber_suspension/estimation/notes.h"

namespace rubber_suspension::apps {

inline void printWarning(const std::string& command, const std::string& warning) {
  std::cerr << command << ": warning: " << log::oneLine(warning) << '\n';
}

/// Of a component's specification.
inline void warnOf(const std::string& command, const io::ComponentDescription& description) {
  for (const std::string& warning : estimation::specificationWarnings(description.written())) {
    printWarning(command, description.name + ": " + warning);
  }
}

/// Of a log, where there is something odd.
inline void warnOf(const std::string& command, const std::string& path, const std::optional<std::string>& odd) {
  if (odd) {
    printWarning(command, path + ": " + *odd);
  }
}

/// Of a log without a temperature for a component that follows one.
inline void warnOfTemperature(const std::string& command, const std::string& path, bool has_temperature,
                              const io::ComponentDescription& description) {
  if (!has_temperature && description.makeComponent().shiftsWithTemperature()) {
    printWarning(command, path + ": has no column temperature_degC: " + description.name +
                              " stays at its reference temperature");
  }
}

}  // namespace rubber_suspension::apps
