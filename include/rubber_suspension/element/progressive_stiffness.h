// Odd stiffening spring: stiffness that rises with amplitude alike in both directions.
#pragma once

#include <cmath>

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// F = k2 z|z| + k3 z^3 + k5 z^5 + k_e (s sinh(z/s) - z), to be added to a linear spring. No loss.
/// Under z = A sin(wt) the cubic term adds 3/4 k3 A^2 to the stiffness of the first harmonic and a third harmonic of
/// -1/4 k3 A^3 (180 degrees). The secant stiffness grows by k2 A + k3 A^2 + k5 A^4.
/// The hyperbolic sine has no slope at z = 0 either and stiffens more steeply than a polynomial; beyond z = 20 s it
/// continues along its tangent. Validity: within the amplitudes that the coefficients were fitted to; a polynomial says
/// nothing beyond. Source: power series of the restoring force, e.g. Nayfeh and Mook, Nonlinear Oscillations (1979),
/// section 2.1; exponential stiffening of Y. C. Fung, Am. J. Physiol. 213 (1967) 1532-1544, alike in both directions.
class ProgressiveStiffness final : public ParallelElement {
 public:
  /// A scale of 0 stands for no exponential; the type's make() throws std::invalid_argument where all is 0.
  ProgressiveStiffness(double cubic /* k3 [N/m^3] */, double quintic /* k5 [N/m^5] */,
                       double quadratic = 0.0 /* k2 [N/m^2] */, double exponential = 0.0 /* k_e [N/m] */,
                       double scale = 0.0 /* s [m] */)
      : cubic_(cubic), quintic_(quintic), quadratic_(quadratic), exponential_(exponential), scale_(scale) {}

  double force(double displacement) const {
    const double square = displacement * displacement;
    const double polynomial =
        displacement * (quadratic_ * std::abs(displacement) + square * (cubic_ + quintic_ * square));
    return polynomial + (scale_ > 0.0 ? stiffening(displacement) : 0.0);
  }

  double initialise(double displacement, double* /*memory*/) const override { return force(displacement); }
  double step(const Motion& motion, double* /*memory*/) const override { return force(motion.displacement); }
  Part part() const override { return Part::elastic; }

 private:
  double stiffening(double displacement) const;

  double cubic_;
  double quintic_;
  double quadratic_;
  double exponential_;
  double scale_;
};

ElementType progressiveStiffnessType();

}  // namespace rubber_suspension::element
