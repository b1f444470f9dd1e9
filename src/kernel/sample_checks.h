// Conditions on many samples, checked side by side.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rubber_suspension::kernel {

/// Returns true if none of the numbers is infinite or NaN.
bool allFinite(const double* value, std::size_t count);

/// Returns true if the magnitude of each number is below two to that power, which is at most 1023.
bool allBelowTwoTo(unsigned power, const double* value, std::size_t count);

/// Returns true if each of the stamps but the first is above the one before it.
bool allIncreasing(const std::int64_t* stamp, std::size_t count);

/// Returns true if the `count` steps from stamp[0] to stamp[count] all have the length `step`, which is more than 0.
bool allEven(const std::int64_t* stamp, std::size_t count, std::uint64_t step);

}  // namespace rubber_suspension::kernel
