// Odd stiffening spring: stiffness that rises with amplitude equally in both directions.
#include <algorithm>
#include <cmath>

#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

/// Simulates F = k2 z|z| + k3 z^3 + k5 z^5 + k_e (s sinh(z/s) - z), to be added to a linear spring. No loss. Under z =
/// A sin(wt) the cubic term adds 3/4 k3 A^2 to the stiffness of the first harmonic, and a third harmonic -1/4 k3 A^3
/// sin(3wt). The polynomial adds k2 A + k3 A^2 + k5 A^4 to the secant stiffness. The term of k_e has no slope at z = 0
/// and stiffens more steeply than a polynomial; beyond |z| = 20 s it continues along its tangent. Validity: the
/// amplitudes for which the coefficients were fitted, since polynomials do not extrapolate. Source: power series of the
/// restoring force, e.g. Nayfeh and Mook, Nonlinear Oscillations (1979), section 2.1; exponential stiffening of Y. C.
/// Fung, Am. J. Physiol. 213 (1967) 1532-1544, here equal in both directions.
class ProgressiveStiffness final : public ParallelElement {
 public:
  /// A scale of 0 means no exponential.
  ProgressiveStiffness(double cubic /* k3 [N/m^3] */, double quintic /* k5 [N/m^5] */,
                       double quadratic /* k2 [N/m^2] */, double exponential /* k_e [N/m] */, double scale /* s [m] */)
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
  double stiffening(double displacement) const {
    constexpr double kSteepest = 20.0;
    const double strain = std::abs(displacement) / scale_;
    const double bounded = std::min(strain, kSteepest);
    const double growth = std::sinh(bounded) - bounded + (strain - bounded) * (std::cosh(bounded) - 1.0);
    return std::copysign(exponential_ * scale_ * growth, displacement);
  }

  double cubic_;
  double quintic_;
  double quadratic_;
  double exponential_;
  double scale_;
};

const ElementEntry kProgressiveStiffnessEntry(
    20, {"progressive_stiffness",
         "Stiffness that rises with amplitude: F = k2 z|z| + k3 z^3 + k5 z^5 + k_e (s sinh(z/s) - z), on "
         "top of a linear spring.",
         {{"quadratic", "N/m^2", Role::scale, Range::nonNegative(),
           "coefficient k2 of z|z|; one of the coefficients must be greater than 0", 0.0},
          {"cubic", "N/m^3", Role::scale, Range::nonNegative(), "coefficient k3", 0.0},
          {"quintic", "N/m^5", Role::scale, Range::nonNegative(), "coefficient k5", 0.0},
          {"exponential", "N/m", Role::scale, Range::nonNegative(), "stiffness k_e of the exponential", 0.0},
          {"exponential_scale", "m", Role::shape, Range::nonNegative(),
           "displacement s over which the exponential grows by a factor of e; 0: no exponential", 0.0}},
         [](const ElementDescription& description) -> ElementPointer {
           const double quadratic = description.value("quadratic");
           const double cubic = description.value("cubic");
           const double quintic = description.value("quintic");
           const double exponential = description.value("exponential");
           const double scale = description.value("exponential_scale");
           if (quadratic == 0.0 && cubic == 0.0 && quintic == 0.0 && exponential == 0.0) {
             refuseValue(description.type, "cubic", cubic, "N/m^3",
                         "at least one of cubic, quadratic, quintic and exponential greater than 0");
           }
           if (scale == 0.0 && exponential != 0.0) {
             refuseValue(description.type, "exponential_scale", scale, "m",
                         "greater than 0 if an exponential is given");
           }
           return std::make_shared<const ProgressiveStiffness>(cubic, quintic, quadratic, exponential, scale);
         }});

}  // namespace
}  // namespace rubber_suspension::element
