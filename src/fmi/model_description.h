// modelDescription.xml: what an importer knows of an FMU before it loads the binary.
#pragma once

#include <map>
#include <string>

#include "fmi/runtime/variables.h"

namespace rubber_suspension::fmi {

/// Version of the standard.
enum class Version { fmi2, fmi3 };

/// Returns the text of modelDescription.xml, in UTF-8. `tool` is the name and version of the exporter.
std::string modelDescription(const ComponentData& data, Version version, const std::string& tool);

/// Exponents of kg, m, s, A, K, rad, mol; those that are 0 are omitted.
using BaseUnit = std::map<std::string, int>;

/// Returns the base units of a unit such as "N s/m" or "N/m^3". There are no factors, since all units are SI except
/// degC. Throws std::invalid_argument for an unknown symbol.
BaseUnit baseUnitOf(const std::string& unit);

/// Returns the offset from a value in this unit to one in its base units.
double offsetOf(const std::string& unit);

}  // namespace rubber_suspension::fmi
