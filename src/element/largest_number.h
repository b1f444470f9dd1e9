// The largest and the smallest number that are accepted from anybody, and what is accepted in place of others.
#pragma once

#include <stdexcept>
#include <string>

#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::element {

/// Largest number [SI] of any Range: larger than in any component; powers of it exceed the range of a double.
constexpr double kLargestNumber = 1e30;

/// Smallest positive value of a quantity [SI]; 0 is accepted if its Range contains 0. Smaller than in any component:
/// products and powers of smaller numbers lose their digits or underflow.
constexpr double kSmallestNumber = 1e-100;

/// A value of a parameter beyond its Range, as refuseValue() throws it.
class ValueOutOfRange : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// As describe(range), behind a value that is out of range, which may be so for its size alone.
std::string acceptedFor(double value, const Range& range);

}  // namespace rubber_suspension::element
