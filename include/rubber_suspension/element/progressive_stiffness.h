// Odd polynomial spring: stiffness that rises with amplitude alike in both directions.
#pragma once

#include <cmath>

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension {

/// F = k2 z|z| + k3 z^3 + k5 z^5, to be added to a linear spring. No loss.
/// Under z = A sin(wt) the cubic term adds 3/4 k3 A^2 to the stiffness of the first harmonic and a third harmonic of
/// -1/4 k3 A^3 (180 degrees). The secant stiffness grows by k2 A + k3 A^2 + k5 A^4.
/// Validity: within the amplitudes that the coefficients were fitted to; a polynomial says nothing beyond.
/// Source: power series of the restoring force, e.g. Nayfeh and Mook, Nonlinear Oscillations (1979), section 2.1.
class ProgressiveStiffness final : public ParallelElement {
 public:
  ProgressiveStiffness(double cubic /* k3 [N/m^3] */, double quintic /* k5 [N/m^5] */,
                       double quadratic = 0.0 /* k2 [N/m^2] */)
      : cubic_(cubic), quintic_(quintic), quadratic_(quadratic) {}

  double force(double displacement) const {
    const double square = displacement * displacement;
    return displacement * (quadratic_ * std::abs(displacement) + square * (cubic_ + quintic_ * square));
  }

  double rest(double displacement, double* /*memory*/) const override { return force(displacement); }
  double step(const Motion& motion, double* /*memory*/) const override { return force(motion.displacement); }
  Part part() const override { return Part::elastic; }

 private:
  double cubic_;
  double quintic_;
  double quadratic_;
};

ElementType progressiveStiffnessType();

}  // namespace rubber_suspension
