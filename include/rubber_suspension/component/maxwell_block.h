// The step of many Maxwell elements, two side by side.
#pragma once

#include <cstddef>
#include <cstring>

namespace rubber_suspension {

/// Two numbers in one register. GCC's vector type, which Clang knows, too.
using Pair = double __attribute__((vector_size(2 * sizeof(double))));

/// Coefficients of the step of eight Maxwell elements, as MaxwellStep has them.
struct alignas(64) MaxwellBlock {
  static constexpr std::size_t kSize = 8;

  Pair decay[kSize / 2];
  Pair gain[kSize / 2];

  /// Advance two elements by an increment of displacement [m], and add their forces [N] to `sum`, one after the other.
  void stepPair(std::size_t pair, double increment, double* force, double& sum) const {
    Pair forces;
    std::memcpy(&forces, force, sizeof forces);
    forces = decay[pair] * forces + gain[pair] * increment;
    std::memcpy(force, &forces, sizeof forces);
    sum += forces[0];
    sum += forces[1];
  }

  /// Advance the first elements, eight at most, likewise. There is no loop: it would cost as much as the elements do.
  void stepFirst(std::size_t count, double increment, double* force, double& sum) const {
    const std::size_t pairs = count / 2;
    double* end = force + 2 * pairs;
    switch (pairs) {
      case 4:
        stepPair(pairs - 4, increment, end - 8, sum);
        [[fallthrough]];
      case 3:
        stepPair(pairs - 3, increment, end - 6, sum);
        [[fallthrough]];
      case 2:
        stepPair(pairs - 2, increment, end - 4, sum);
        [[fallthrough]];
      case 1:
        stepPair(pairs - 1, increment, end - 2, sum);
        [[fallthrough]];
      default:
        break;
    }
    if (count % 2 != 0) {
      *end = decay[pairs][0] * *end + gain[pairs][0] * increment;
      sum += *end;
    }
  }
};

/// Advances so many Maxwell elements by an increment of displacement [m]; returns `sum` and their forces [N], added in
/// their order. `force` is what they remember.
inline double stepMaxwells(const MaxwellBlock* block, std::size_t count, double increment, double sum, double* force) {
  for (; count > MaxwellBlock::kSize; count -= MaxwellBlock::kSize) {
    block->stepFirst(MaxwellBlock::kSize, increment, force, sum);
    ++block;
    force += MaxwellBlock::kSize;
  }
  block->stepFirst(count, increment, force, sum);
  return sum;
}

}  // namespace rubber_suspension
