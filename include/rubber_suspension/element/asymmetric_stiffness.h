// Even part of a characteristic: a component that is stiffer in one direction than in the other.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// F = k2 z^2 + k_d |z|/2 + k_h s (cosh(z/s) - 1) + k_t max(z, 0) + k_e (s (exp(z/s) - 1) - z), to be added to a linear
/// spring. No loss. The first three terms are even: they hold nothing of a spring or of progressive_stiffness, which
/// are odd. The fourth is even but for a linear part; the last one has an odd part of the same size. Under a sine of
/// amplitude A the first term shifts the mean force by k2 A^2/2 and adds a second harmonic of as much. Validity: the
/// coefficients may have either sign, so the tangent stiffness of the component becomes negative where the linear
/// spring no longer outweighs them, below z = -k/(2 k2) for k2 > 0; keep well within. The last exponential stiffens on
/// the side of the sign of s, as rubber that is compressed far does; the even one stiffens one side and softens the
/// other. Neither has a slope at z = 0; beyond |z| = 20 |s| both continue along their tangents. Source: power series of
/// the restoring force, e.g. Nayfeh and Mook, Nonlinear Oscillations (1979), section 2.1; exponential stiffening of Y.
/// C. Fung, Am. J. Physiol. 213 (1967) 1532-1544. The type's make() throws std::invalid_argument.
class AsymmetricStiffness final : public ParallelElement {
 public:
  struct Exponentials {
    double one_sided = 0.0;  ///< k_e [N/m]
    double even = 0.0;       ///< k_h [N/m]
    double scale = 0.0;      ///< s [m]; 0: none
  };

  AsymmetricStiffness(double quadratic /* k2 [N/m^2] */, double tension_stiffness /* k_t [N/m] */,
                      const Exponentials& exponentials, double slope_difference = 0.0 /* k_d [N/m] */)
      : quadratic_(quadratic),
        upper_slope_(tension_stiffness + 0.5 * slope_difference),
        lower_slope_(-0.5 * slope_difference),
        exponentials_(exponentials) {}

  double force(double displacement) const {
    const double slope = displacement > 0.0 ? upper_slope_ : lower_slope_;
    return displacement * (quadratic_ * displacement + slope) +
           (exponentials_.scale != 0.0 ? stiffening(displacement) : 0.0);
  }

  double initialise(double displacement, double* /*memory*/) const override { return force(displacement); }
  double step(const Motion& motion, double* /*memory*/) const override { return force(motion.displacement); }
  Part part() const override { return Part::elastic; }
  bool passive() const override { return false; }

 private:
  double stiffening(double displacement) const;

  double quadratic_;
  double upper_slope_;  // at z > 0 [N/m]
  double lower_slope_;
  Exponentials exponentials_;
};

ElementType asymmetricStiffnessType();

}  // namespace rubber_suspension::element
