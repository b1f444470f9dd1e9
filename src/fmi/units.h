// Units of UDUNITS spelling in the base units that FMI knows.
#pragma once

#include <map>
#include <string>

namespace rubber_suspension::fmi {

/// Exponents of kg, m, s, A, K, rad, mol; those that are 0 are left out.
using BaseUnit = std::map<std::string, int>;

/// The base units of a unit such as "N s/m" or "N/m^3". Factors are not needed: all units inside are SI, but
/// for degC. Throws std::invalid_argument on a symbol that it does not know.
BaseUnit baseUnitOf(const std::string& unit);

/// What is added to a value in this unit for one in its base units.
double offsetOf(const std::string& unit);

}  // namespace rubber_suspension::fmi
