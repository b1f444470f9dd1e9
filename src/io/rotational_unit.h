// Units of rotations.
#pragma once

#include <string>

namespace rubber_suspension::io {

/// Returns the SI unit of a rotation that corresponds to `unit` of a translation: rad for m, N m for N. Returns any
/// other unit unchanged.
std::string rotationalUnit(const std::string& unit);

}  // namespace rubber_suspension::io
