// Dashpots for a displacement that is smooth between samples. Throws nothing.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// Base of dashpots that need the rate at a sample. The rate is extrapolated linearly from the mean rates of the last
/// two steps. For a displacement that is smooth between samples the extrapolated rate has no lag (its phase error is of
/// order (w dt)^3), but nearly twice the noise of a mean rate. The force at rest is 0. Memory: mean rate and length of
/// the last step, which are 0 after a rest.
class SmoothRateDashpot : public ParallelElement {
 public:
  std::size_t memorySize() const final { return 2; }
  Part part() const final { return Part::viscous; }

 protected:
  /// Returns the rate [m/s] at the end of the step and stores the mean rate, so it must be called once per step.
  static double rateAfter(const Motion& motion, double* memory) {
    const double rate = motion.increment / motion.dt;
    const double ahead = memory[1] > 0.0 ? motion.dt / (motion.dt + memory[1]) : 0.0;
    const double at_end = rate + ahead * (rate - memory[0]);
    memory[0] = rate;
    memory[1] = motion.dt;
    return at_end;
  }
};

}  // namespace rubber_suspension::element
