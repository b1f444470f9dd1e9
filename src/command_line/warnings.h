// Prints warnings of inputs that are valid but suspicious, one line each on stderr. All commands share these warnings.
#pragma once

#include <optional>
#include <string>

#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::command_line {

/// Warns of suspicious values in a component's specification.
void warnOf(const std::string& command, const io::ComponentDescription& description);

/// Warns of a log if `odd` states what is suspicious in it.
void warnOf(const std::string& command, const std::string& path, const std::optional<std::string>& odd);

/// Warns if the component depends on temperature and the log has none.
void warnOfTemperature(const std::string& command, const std::string& path, bool has_temperature,
                       const io::ComponentDescription& description);

}  // namespace rubber_suspension::command_line
