// Options of a command that are legal and odd, one line each on stderr: the same words for every command.
#pragma once

#include <optional>
#include <string>

#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::command_line {

/// Of a component's specification.
void warnOf(const std::string& command, const io::ComponentDescription& description);

/// Of a log, where there is something odd.
void warnOf(const std::string& command, const std::string& path, const std::optional<std::string>& odd);

/// Of a log without a temperature for a component that follows one.
void warnOfTemperature(const std::string& command, const std::string& path, bool has_temperature,
                       const io::ComponentDescription& description);

}  // namespace rubber_suspension::command_line
