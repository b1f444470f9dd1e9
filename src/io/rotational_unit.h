// Units of rotations.
#pragma once

#include <string>

namespace rubber_suspension::io {

/// Returns the SI unit for rotations that corresponds to one for translations: rad for m, N m for N; else `unit`.
std::string rotationalUnit(const std::string& unit);

}  // namespace rubber_suspension::io
