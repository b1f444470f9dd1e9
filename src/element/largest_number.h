// The largest and the smallest number that are accepted from anybody, and what is accepted in place of others.
#pragma once

#include <string>

#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::element {

/// In SI units, beyond any component, and where powers of it leave the range of a double. No Range contains more.
constexpr double kLargestNumber = 1e30;

/// Of a quantity that cannot be negative; 0 itself is accepted where its Range contains 0. In SI units, below any
/// component, and where products and powers of it lose their digits or become 0.
constexpr double kSmallestNumber = 1e-100;

/// As describe(range), behind a value that is out of range, which may be so for its size alone.
std::string acceptedFor(double value, const Range& range);

}  // namespace rubber_suspension::element
