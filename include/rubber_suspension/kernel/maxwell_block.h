// The step of many Maxwell elements, two in each vector register. No function here throws.
#pragma once

#include <cstddef>
#include <cstring>

#include "rubber_suspension/element/maxwell.h"

namespace rubber_suspension::kernel {

constexpr std::size_t kCacheLine = 64;  ///< size of a cache line [bytes]

/// Two numbers in one vector register, by a type of GCC that Clang also supports.
using Pair = double __attribute__((vector_size(2 * sizeof(double))));

/// Coefficients of the step of eight Maxwell elements (see MaxwellStep).
struct alignas(kCacheLine) MaxwellBlock {
  static constexpr std::size_t kSize = 8;

  Pair decay[kSize / 2];
  Pair gain[kSize / 2];

  /// Advances two elements by an increment of displacement [m], and adds first one and then the other force [N] to the
  /// first number of `sum`. The second number of `sum` is not used.
  void stepPair(std::size_t pair, double increment, double* force, Pair& sum) const {
    Pair forces;
    std::memcpy(&forces, force, sizeof forces);
    forces = element::maxwellForce(decay[pair], gain[pair], forces, increment);
    std::memcpy(force, &forces, sizeof forces);
    sum += forces;
    sum += Pair{forces[1], forces[1]};
  }

  /// Advances the first `count` elements, at most eight, as stepPair() does. Recursion replaces a loop, which would
  /// take as much time as the elements; nested conditions avoid the computation of addresses.
  template <std::size_t first = 0>
  __attribute__((always_inline)) void stepFirst(std::size_t count, double increment, double* force, Pair& sum) const {
    if constexpr (first < kSize) {
      if (count >= first + 2) {
        stepPair(first / 2, increment, force + first, sum);
        stepFirst<first + 2>(count, increment, force, sum);
      } else if (count > first) {
        force[first] = element::maxwellForce(decay[first / 2][0], gain[first / 2][0], force[first], increment);
        sum[0] += force[first];
      }
    }
  }
};

/// Advances `count` Maxwell elements by an increment of displacement [m]. Adds their forces [N] to `start` in order and
/// returns the sum. `force` is their memory.
__attribute__((always_inline)) inline double stepMaxwells(const MaxwellBlock* block, std::size_t count,
                                                          double increment, double start, double* force) {
  Pair sum = {start, 0.0};
  for (; count > MaxwellBlock::kSize; count -= MaxwellBlock::kSize) {
    block->stepFirst(MaxwellBlock::kSize, increment, force, sum);
    ++block;
    force += MaxwellBlock::kSize;
  }
  block->stepFirst(count, increment, force, sum);
  return sum[0];
}

}  // namespace rubber_suspension::kernel
