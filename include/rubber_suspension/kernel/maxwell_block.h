// The step of many Maxwell elements, two side by side. Throws nothing.
#pragma once

#include <cstddef>
#include <cstring>

#include "rubber_suspension/element/maxwell.h"

namespace rubber_suspension::kernel {

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
    forces = element::maxwellForce(decay[pair], gain[pair], forces, increment);
    std::memcpy(force, &forces, sizeof forces);
    sum += forces[0];
    sum += forces[1];
  }

  /// Advance the first elements, eight at most, likewise. Without a loop, which would cost as much as the elements do,
  /// and nested, so that no address is computed.
  void stepFirst(std::size_t count, double increment, double* force, double& sum) const {
    if (count >= 2) {
      stepPair(0, increment, force, sum);
      if (count >= 4) {
        stepPair(1, increment, force + 2, sum);
        if (count >= 6) {
          stepPair(2, increment, force + 4, sum);
          if (count >= 8) {
            stepPair(3, increment, force + 6, sum);
          }
        }
      }
    }
    if (count % 2 != 0) {
      const std::size_t last = count - 1;
      force[last] = element::maxwellForce(reinterpret_cast<const double*>(decay)[last],
                                          reinterpret_cast<const double*>(gain)[last], force[last], increment);
      sum += force[last];
    }
  }
};

/// Advances `count` Maxwell elements by an increment of displacement [m]; returns `sum` and their forces [N], added in
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

}  // namespace rubber_suspension::kernel
