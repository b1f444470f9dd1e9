// Checks of many samples by vector instructions.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rubber_suspension::kernel {

/// Returns true if none of the numbers is infinite or NaN.
bool allFinite(const double* value, std::size_t count);

/// Returns true if the magnitude of each number is below 2^power, with a power of at most 1023.
bool allBelowTwoTo(unsigned power, const double* value, std::size_t count);

/// Returns true if each stamp is greater than the preceding one.
bool allIncreasing(const std::int64_t* stamp, std::size_t count);

/// Returns true if all `count` steps, from stamp[0] to stamp[count], have the length `step`, which has to be positive.
bool allEven(const std::int64_t* stamp, std::size_t count, std::uint64_t step);

}  // namespace rubber_suspension::kernel
