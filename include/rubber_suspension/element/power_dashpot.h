// Dashpot whose force follows a power of the rate. Throws nothing: makeElement() checks the values.
#pragma once

#include "rubber_suspension/element/smooth_rate.h"

namespace rubber_suspension::element {

/// F = c v_r sign(v) |v/v_r|^p, v = dz/dt: at the rate v_r the force of a dashpot c. p = 2: fluid through an orifice;
/// p < 1: what thins under shear. The rate at a sample is that of SmoothRateDashpot; noise of the displacement makes
/// about 2.5/dt times as much of it, which a small p turns into much force where the motion turns. Source: power-law
/// damper, e.g. Constantinou and Symans, NCEER-92-0032 (1992), section 5.
class PowerDashpot final : public SmoothRateDashpot {
 public:
  PowerDashpot(double damping /* c [N s/m] */, double reference_rate /* v_r [m/s] */, double exponent /* p [-] */);

  double step(const Motion& motion, double* memory) const override { return force(rateAfter(motion, memory)); }

  /// Force [N] at a rate [m/s].
  double force(double rate) const;

 private:
  double damping_;
  double reference_rate_;
  double exponent_;
};

ElementType powerDashpotType();

}  // namespace rubber_suspension::element
