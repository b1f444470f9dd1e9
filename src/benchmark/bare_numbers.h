// The numbers of the bare loop over blocks.
#pragma once

#include "benchmark/bare_lanes.h"

namespace rubber_suspension::benchmark {

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
