// Units of rotations.
#pragma once

#include <string>

namespace rubber_suspension::io {

/// Returns the SI unit of rotations that corresponds to `unit`: rad for m, N m for N, otherwise `unit`.
std::string rotationalUnit(const std::string& unit);

}  // namespace rubber_suspension::io
