// Maxwell element whose dashpot yields to large forces: rate and amplitude dependence that are coupled.
#pragma once

#include "rubber_suspension/element/maxwell.h"

namespace rubber_suspension::element {

/// dF/dt = k dz/dt - F/tau (1 + |F|/(k y)), tau = 1/(2 pi f_b): a Maxwell element at displacements well below y, one
/// that relaxes the faster the larger its force beyond. So the stiffness falls with amplitude, but only at frequencies
/// at which the element takes part at all; friction beside a Maxwell element, a sum, cannot do that. For a given y the
/// force scales with k.
///
/// Stepped by splitting: half of the quadratic relaxation, the exact linear step, the other half. Exact in the limit of
/// a large y, of second order in dt/tau |F|/(k y) else, and it dissipates at any step. Memory: the force. Source: flow
/// that is activated by stress, J. S. Bergstrom and M. C. Boyce, J. Mech. Phys. Solids 46 (1998) 931-954, in one
/// dimension and to the second order of the force. Throws nothing: makeElement() checks the values.
class NonlinearMaxwell final : public ParallelElement {
 public:
  NonlinearMaxwell(double stiffness /* k [N/m] */, double break_frequency /* f_b [Hz] */,
                   double displacement /* y [m] */)
      : linear_(stiffness, break_frequency), force_(stiffness * displacement) {}

  std::size_t memorySize() const override { return linear_.memorySize(); }
  double initialise(double displacement, double* memory) const override {
    return linear_.initialise(displacement, memory);
  }
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::viscous; }

 private:
  Maxwell linear_;
  double force_;  // k y [N]
};

ElementType nonlinearMaxwellType();

}  // namespace rubber_suspension::element
