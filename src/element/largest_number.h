// The largest number that is taken from anybody, and what is accepted in place of a larger one.
#pragma once

#include <string>

#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::element {

/// In SI units, beyond any component, and where powers of it leave the range of a double. No Range contains more.
constexpr double kLargestNumber = 1e30;

/// As describe(range), behind a value that is out of range, which may be so for its size alone.
std::string acceptedFor(double value, const Range& range);

}  // namespace rubber_suspension::element
