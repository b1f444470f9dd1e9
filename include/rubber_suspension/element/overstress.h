// Spring that flows beyond a limit of its force, the faster the farther beyond. Throws nothing.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// dF/dt = k (dz/dt - v_r sign(F) max(0, |F|/(k y) - 1)^m): elastic up to the limit k y, at a steady rate v a force of
/// k y (1 + (v/v_r)^(1/m)), and a slider in the limit of slow motion. So amplitude dependence depends on the rate, and
/// a hold keeps k y. The force is linear in k, the others given.
///
/// The flow of a step is that at its end (flowRoot()): exact in steady flow, of first order in the step else, and it
/// dissipates at any step. Memory: the displacement of the spring over y. Source: overstress, P. Perzyna, Adv. Appl.
/// Mech. 9 (1966) 243-377; for elastomers with an equilibrium hysteresis P. Haupt and K. Sedlan, Arch. Appl. Mech. 71
/// (2001) 89-109.
class Overstress final : public ParallelElement {
 public:
  struct Parameters {
    double stiffness;           // k [N/m]
    double yield_displacement;  // y [m]
    double reference_rate;      // v_r [m/s]
    double power;               // m [-]
  };

  explicit Overstress(const Parameters& parameters) : parameters_(parameters) {}

  std::size_t memorySize() const override { return 1; }
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::friction; }

 private:
  Parameters parameters_;
};

ElementType overstressType();

}  // namespace rubber_suspension::element
