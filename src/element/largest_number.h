// The largest and smallest numbers that a parameter may have, and their part of the error messages.
#pragma once

#include <stdexcept>
#include <string>

#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::element {

/// Largest magnitude [SI] in any Range: larger than in any component; powers of larger numbers overflow.
constexpr double kLargestNumber = 1e30;

/// Smallest positive value [SI] in a Range without negative values; 0 is accepted if the Range contains it. Smaller
/// than in any component: products and powers of smaller numbers lose their digits or underflow.
constexpr double kSmallestNumber = 1e-100;

/// Thrown by refuseValue() for a value outside its Range.
class ValueOutOfRange : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Returns describe(range), with the largest or the smallest number if the value violates that limit.
std::string acceptedFor(double value, const Range& range);

}  // namespace rubber_suspension::element
