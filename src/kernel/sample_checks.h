// Conditions on many samples, checked side by side.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rubber_suspension::kernel {

/// True where none of the numbers is infinite or not a number.
bool allFinite(const double* value, std::size_t count);

/// True where the size of each of the numbers is below two to that power, of at most 1023.
bool allBelowTwoTo(unsigned power, const double* value, std::size_t count);

/// True where each of the stamps but the first is above the one before it.
bool allIncreasing(const std::int64_t* stamp, std::size_t count);

/// True where that many steps from stamp[0] on, to stamp[count], are all of one length, more than 0.
bool allEven(const std::int64_t* stamp, std::size_t count, std::uint64_t step);

}  // namespace rubber_suspension::kernel
