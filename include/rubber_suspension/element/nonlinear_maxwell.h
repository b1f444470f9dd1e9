// Maxwell element whose dashpot yields to large forces: rate and amplitude dependence that are coupled.
#pragma once

#include "rubber_suspension/element/maxwell.h"

namespace rubber_suspension::element {

/// dF/dt = k dz/dt - F/tau (1 + (|F|/(k y))^p), tau = 1/(2 pi f_b): a Maxwell element at displacements well below y,
/// one that relaxes the faster the larger its force beyond; the larger the power p, the more y is a limit. So the
/// stiffness falls with amplitude, but only at frequencies at which the element takes part at all; friction beside a
/// Maxwell element, a sum, cannot do that. For a given y the force scales with k.
///
/// Stepped by splitting: half of the relaxation by the power, the exact linear step, the other half. Exact in the limit
/// of a large y, of second order in dt/tau (|F|/(k y))^p else, and it dissipates at any step. Memory: the force.
/// Source: flow that is activated by stress, J. S. Bergstrom and M. C. Boyce, J. Mech. Phys. Solids 46 (1998) 931-954,
/// in one dimension, beside a linear part; p + 1 is their power m. Throws nothing: makeElement() checks the values.
class NonlinearMaxwell final : public ParallelElement {
 public:
  NonlinearMaxwell(double stiffness /* k [N/m] */, double break_frequency /* f_b [Hz] */,
                   double displacement /* y [m] */, double power = 1.0 /* p [-] */)
      : linear_(stiffness, break_frequency), force_(stiffness * displacement), power_(power) {}

  std::size_t memorySize() const override { return linear_.memorySize(); }
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::viscous; }

 private:
  double yielded(double force, double relaxation_times) const;

  Maxwell linear_;
  double force_;  // k y [N]
  double power_;
};

ElementType nonlinearMaxwellType();

}  // namespace rubber_suspension::element
