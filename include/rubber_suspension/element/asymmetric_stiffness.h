// Even part of a characteristic: a component that is stiffer in one direction than in the other.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// F = k2 z^2 + k_t max(z, 0) + k_e (s (exp(z/s) - 1) - z), to be added to a linear spring. No loss.
/// Under a sine of amplitude A the first term shifts the mean force by k2 A^2/2 and adds a second harmonic of as much.
/// Validity: the coefficients may have either sign, so the tangent stiffness of the component becomes negative where
/// the linear spring no longer outweighs them, below z = -k/(2 k2) for k2 > 0; keep well within. The exponential
/// stiffens on the side of the sign of s, as rubber that is compressed far does, and has no slope at z = 0; beyond z =
/// 20 s it goes on along its tangent. Source: power series of the restoring force, e.g. Nayfeh and Mook, Nonlinear
/// Oscillations (1979), section 2.1; exponential stiffening of Y. C. Fung, Am. J. Physiol. 213 (1967) 1532-1544.
class AsymmetricStiffness final : public ParallelElement {
 public:
  /// A scale of 0 stands for no exponential.
  AsymmetricStiffness(double quadratic /* k2 [N/m^2] */, double tension_stiffness /* k_t [N/m] */,
                      double exponential = 0.0 /* k_e [N/m] */, double scale = 0.0 /* s [m] */)
      : quadratic_(quadratic), tension_stiffness_(tension_stiffness), exponential_(exponential), scale_(scale) {}

  double force(double displacement) const {
    const double tension = displacement > 0.0 ? tension_stiffness_ : 0.0;
    return displacement * (quadratic_ * displacement + tension) + (scale_ != 0.0 ? stiffening(displacement) : 0.0);
  }

  double initialise(double displacement, double* /*memory*/) const override { return force(displacement); }
  double step(const Motion& motion, double* /*memory*/) const override { return force(motion.displacement); }
  Part part() const override { return Part::elastic; }
  bool passive() const override { return false; }

 private:
  double stiffening(double displacement) const;

  double quadratic_;
  double tension_stiffness_;
  double exponential_;
  double scale_;
};

ElementType asymmetricStiffnessType();

}  // namespace rubber_suspension::element
