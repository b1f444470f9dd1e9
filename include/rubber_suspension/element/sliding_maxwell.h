// Maxwell element with a slider: relaxes below a limit of its force and slides at it. Throws nothing.
#pragma once

#include <algorithm>

#include "rubber_suspension/element/maxwell.h"

namespace rubber_suspension::element {

/// dF/dt = k dz/dt - F/tau while |F| < k y, tau = 1/(2 pi f_b); |F| = k y where it would exceed that. Below the break
/// frequency it relaxes before it slides, above it slides at the amplitude y: the stiffness falls with amplitude at
/// high frequency only. For a given y the force scales with k.
///
/// Between samples the force tends monotonically to its limit, so to cut it at the end of the step is exact for a
/// displacement that is linear in between. Dissipates. Memory: the force. Source: J. F. Besseling, J. Appl. Mech. 25
/// (1958) 529-536 (sublayers that yield); as an overlay model of rubber: P.-E. Austrell, A. K. Olsson, Polymer Testing
/// 32 (2013) 306-312.
class SlidingMaxwell final : public ParallelElement {
 public:
  SlidingMaxwell(double stiffness /* k [N/m] */, double break_frequency /* f_b [Hz] */,
                 double yield_displacement /* y [m] */)
      : linear_(stiffness, break_frequency), limit_(stiffness * yield_displacement) {}

  std::size_t memorySize() const override { return linear_.memorySize(); }
  double step(const Motion& motion, double* memory) const override {
    return memory[0] = std::clamp(linear_.step(motion, memory), -limit_, limit_);
  }
  Part part() const override { return Part::viscous; }

 private:
  Maxwell linear_;
  double limit_;  // k y [N]
};

ElementType slidingMaxwellType();

}  // namespace rubber_suspension::element
