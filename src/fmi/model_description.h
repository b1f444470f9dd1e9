// modelDescription.xml, from which an importer knows the variables of an FMU before it loads the binary.
#pragma once

#include <map>
#include <string>

#include "fmi/runtime/variables.h"

namespace rubber_suspension::fmi {

enum class Version { fmi2, fmi3 };

/// Returns the text of modelDescription.xml, in UTF-8. `tool` is the name and version of the exporter.
std::string modelDescription(const ComponentData& data, Version version, const std::string& tool);

/// Exponents of kg, m, s, A, K, rad, mol; exponents of 0 are omitted.
using BaseUnit = std::map<std::string, int>;

/// Returns the base units of a unit such as "N s/m" or "N/m^3". No factors are needed, since all units but degC are SI.
/// Throws std::invalid_argument for an unknown symbol.
BaseUnit baseUnitOf(const std::string& unit);

/// Returns the number to add to a value in this unit to convert it to base units, which is not 0 for degC.
double offsetOf(const std::string& unit);

}  // namespace rubber_suspension::fmi
