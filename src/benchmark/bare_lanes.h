// What vector instructions make of the same work, written by hand for five Maxwell elements and Berg friction alone,
// with products and sums fused: a block of a log at a time, many components at a tick, one log for many components.
#pragma once

#include <vector>

#include "benchmark/bare_loop.h"

namespace rubber_suspension::benchmark {

/// Five Maxwell elements.
constexpr std::size_t kBareElements = 5;

/// Force [N] at every sample as bareLoop() has it, by the state-space form: a few samples at once from the state before
/// them.
void bareBlockLoop(const BareParameters& parameters, double dt, const std::vector<double>& displacement,
                   std::vector<double>& force);

/// One number of each of eight components.
struct alignas(64) BareRow {
  double lane[8];
};

/// Many components side by side, a multiple of eight.
class BareLanes {
 public:
  BareLanes(const std::vector<BareParameters>& parameters, double dt);

  /// At rest at a displacement [m].
  void rest(double displacement);

  /// Bring each to its displacement [m]; each turns for itself.
  void tick(const double* displacement, double* force);

  /// One log for all, from rest at its first displacement [m]; all turn at once. `sum` gets each component's sum of
  /// squared forces [N^2] without the first sample.
  void sumSquares(const std::vector<double>& displacement, double* sum);

 private:
  std::vector<BareRow> rows_;
};

}  // namespace rubber_suspension::benchmark
