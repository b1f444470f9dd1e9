// How the numbers of the bare lane loops lie in memory.
#pragma once

#include "benchmark/bare_lanes.h"

namespace rubber_suspension::benchmark {

enum BareSlot : std::size_t {
  kBareSpring,
  kBareMaximumForce,
  kBareCompliance,
  kBareReferenceDisplacement,
  kBareReferenceForce,
  kBareDirection,
  kBareDisplacement,
  kBareDecay,
  kBareGain = kBareDecay + kBareElements,
  kBareForce = kBareGain + kBareElements,
  kBareRows = kBareForce + kBareElements
};

struct BareBlock {
  double spring;
  double maximum_force;
  double friction_displacement;
  double decay[kBareElements];
  double gain[kBareElements];
  const double* displacement;
  std::size_t count;
  double* force;
};

}  // namespace rubber_suspension::benchmark
