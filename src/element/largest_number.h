// The largest and the smallest number that a parameter may have, and their text in error messages.
#pragma once

#include <stdexcept>
#include <string>

#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::element {

/// Largest magnitude [SI] in any Range, beyond the values of any component. Powers of larger numbers would overflow.
constexpr double kLargestNumber = 1e30;

/// Smallest positive value [SI] in a Range without negative values, which is below the values of any component. 0 is
/// accepted if the Range contains it. Products and powers of smaller numbers would lose digits or underflow.
constexpr double kSmallestNumber = 1e-100;

/// Thrown by refuseValue() for a value outside its Range.
class ValueOutOfRange : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Returns describe(range), supplemented by kLargestNumber or kSmallestNumber if the value violates this limit.
std::string acceptedFor(double value, const Range& range);

}  // namespace rubber_suspension::element
