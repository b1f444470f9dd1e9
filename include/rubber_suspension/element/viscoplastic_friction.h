// Friction that a rate brings to its limit: a spring in series with a dashpot whose force has a limit. Throws nothing.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// dF/dt = k (dz/dt - v_0 F/(k y - |F|)): at a steady rate v, F = k y v/(v_0 + |v|).
///
/// Half of the limit k y is reached at the rate v_0; at rates far above v_0 it is Coulomb's friction behind a contact
/// spring, which slides at the displacement y; of small force it is a Maxwell element of tau = y/v_0. So is the force
/// of a fluid with a yield stress, as in a magnetorheological damper, and of a seal on an oil film. For given y and v_0
/// the force scales with k.
///
/// Stepped by the implicit Euler method, solved in closed form: of first order in dt v_0/y, below its limit and
/// dissipating at any step. Memory: force over the limit. Source: the dashpot after M. M. Cross, J. Colloid Sci. 20
/// (1965) 417-437, of exponent 1 and without a second plateau; in series with a spring before yield: D. R. Gamota and
/// F. E. Filisko, J. Rheol. 35 (1991) 399-425.
class ViscoplasticFriction final : public ParallelElement {
 public:
  ViscoplasticFriction(double stiffness /* k [N/m] */, double yield_displacement /* y [m] */,
                       double half_rate /* v_0 [m/s] */)
      : stiffness_(stiffness), yield_displacement_(yield_displacement), half_rate_(half_rate) {}

  std::size_t memorySize() const override { return 1; }
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::friction; }

 private:
  double stiffness_;
  double yield_displacement_;
  double half_rate_;
};

ElementType viscoplasticFrictionType();

}  // namespace rubber_suspension::element
