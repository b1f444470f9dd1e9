// Dashpots whose displacement is smooth between samples. Throws nothing.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// Base of dashpots that need the rate at a sample. For a displacement that is smooth between samples, the rate
/// extrapolated linearly from the mean rates of the last two steps has no lag (error of phase of order (w dt)^3). It
/// doubles the noise of the rate. At rest there is no force. Memory: mean rate and length of the step before (0 after a
/// rest).
class SmoothRateDashpot : public ParallelElement {
 public:
  std::size_t memorySize() const final { return 2; }
  Part part() const final { return Part::viscous; }

 protected:
  /// The rate [m/s] at the end of the step; once a step.
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
