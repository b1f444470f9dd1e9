// The step of many Maxwell elements, two side by side.
#pragma once

#include <cstddef>
#include <cstring>

namespace rubber_suspension {

/// Two numbers in one register. GCC's vector type, which Clang knows, too.
using Pair = double __attribute__((vector_size(2 * sizeof(double))));

inline Pair loadPair(const double* numbers) {
  Pair pair;
  std::memcpy(&pair, numbers, sizeof pair);
  return pair;
}

/// Coefficients of the step of two Maxwell elements, as MaxwellStep has them. Of an odd number of elements the last one
/// has a pair for itself.
struct MaxwellPair {
  Pair decay;
  Pair gain;
};

/// Advances two elements; adds their forces to `sum`, one after the other.
inline void stepPair(const MaxwellPair& pair, double increment, double* force, double& sum) {
  const Pair forces = pair.decay * loadPair(force) + pair.gain * increment;
  std::memcpy(force, &forces, sizeof forces);
  sum += forces[0];
  sum += forces[1];
}

/// Advances so many elements by an increment of displacement [m]; returns `sum` and their forces [N], added in their
/// order. `force` is what they remember. The last four pairs are without a loop, which would cost as much as they do.
inline double stepMaxwells(const MaxwellPair* pair, std::size_t count, double increment, double sum, double* force) {
  const std::size_t pairs = count / 2;
  pair += pairs;
  force += 2 * pairs;
  switch (pairs) {
    default:
      for (std::size_t left = pairs; left > 4; --left) {
        stepPair(*(pair - left), increment, force - 2 * left, sum);
      }
      [[fallthrough]];
    case 4:
      stepPair(pair[-4], increment, force - 8, sum);
      [[fallthrough]];
    case 3:
      stepPair(pair[-3], increment, force - 6, sum);
      [[fallthrough]];
    case 2:
      stepPair(pair[-2], increment, force - 4, sum);
      [[fallthrough]];
    case 1:
      stepPair(pair[-1], increment, force - 2, sum);
      [[fallthrough]];
    case 0:
      break;
  }
  if (count % 2 != 0) {
    *force = pair->decay[0] * *force + pair->gain[0] * increment;
    sum += *force;
  }
  return sum;
}

}  // namespace rubber_suspension
