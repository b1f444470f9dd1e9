// Units of rotations.
#pragma once

#include <string>

namespace rubber_suspension::io {

/// The unit of a rotation for one of a translation, SI: rad for m, N m for N. Itself where it has neither.
std::string rotationalUnit(const std::string& unit);

}  // namespace rubber_suspension::io
