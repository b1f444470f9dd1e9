// Units of rotations.
#pragma once

#include <string>

namespace rubber_suspension::io {

/// Returns the SI unit of the rotational quantity that corresponds to a translational one: rad for m, N m for N.
/// Returns other units unchanged.
std::string rotationalUnit(const std::string& unit);

}  // namespace rubber_suspension::io
