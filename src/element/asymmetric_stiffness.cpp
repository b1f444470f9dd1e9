// Even part of a characteristic: a component that is stiffer in one direction than in the other.
#include <algorithm>
#include <cmath>

#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

// Returns exp(x) - 1 - x, continued along its tangent beyond x = 20.
double growth(double strain) {
  constexpr double kSteepest = 20.0;
  const double bounded = std::min(strain, kSteepest);
  return std::expm1(bounded) - bounded + (strain - bounded) * std::expm1(bounded);
}

/// Simulates F = k2 z^2 + k_d |z|/2 + k_h s (cosh(z/s) - 1) + k_t max(z, 0) + k_e (s (exp(z/s) - 1) - z), to be added
/// to a linear spring. No loss. The terms of k2, k_d and k_h are even, so they do not overlap with a spring or
/// progressive_stiffness, which are odd. The term of k_t is even except for a linear part. The term of k_e also has an
/// odd part. Under a sine of amplitude A the term of k2 shifts the mean force by k2 A^2/2 and adds a second harmonic of
/// the amplitude k2 A^2/2. The term of k_e stiffens on the side of the sign of s, as rubber under large compression
/// does; the term of k_h stiffens one side and softens the other. Both exponential terms have no slope at z = 0 and
/// continue along their tangents beyond |z| = 20 |s|. Validity: motions must stay well within the range where the
/// tangent stiffness of the component is positive. With a linear spring k and k2 > 0 alone, this range ends at z =
/// -k/(2 k2). Source: power series of the restoring force, e.g. Nayfeh and Mook, Nonlinear Oscillations (1979), section
/// 2.1; exponential stiffening of Y. C. Fung, Am. J. Physiol. 213 (1967) 1532-1544.
class AsymmetricStiffness final : public ParallelElement {
 public:
  struct Exponentials {
    double one_sided;  ///< k_e [N/m]
    double even;       ///< k_h [N/m]
    double scale;      ///< s [m]; 0: none
  };

  AsymmetricStiffness(double quadratic /* k2 [N/m^2] */, double tension_stiffness /* k_t [N/m] */,
                      const Exponentials& exponentials, double slope_difference /* k_d [N/m] */)
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
  double stiffening(double displacement) const {
    const double scale = exponentials_.scale;
    const double upper = growth(displacement / scale);
    const double even = 0.5 * exponentials_.even * std::abs(scale) * (upper + growth(-displacement / scale));
    return exponentials_.one_sided * scale * upper + even;
  }

  double quadratic_;
  double upper_slope_;  // slope of k_d and k_t at z > 0 [N/m]
  double lower_slope_;
  Exponentials exponentials_;
};

const ElementEntry kAsymmetricStiffnessEntry(
    30, {"asymmetric_stiffness",
         "Different stiffness in the two directions: F = k2 z^2 + k_d |z|/2 + k_h s (cosh(z/s) - 1) + "
         "k_t max(z, 0) + k_e (s (exp(z/s) - 1) - z), on top of a linear spring.",
         {{"quadratic", "N/m^2", Role::scale, Range::any(), "coefficient k2, of either sign", 0.0},
          {"slope_difference", "N/m", Role::scale, Range::any(),
           "difference k_d between the stiffness at z > 0 and at z < 0, whose mean is unchanged; of either sign", 0.0},
          {"tension_stiffness", "N/m", Role::scale, Range::any(), "extra stiffness k_t at z > 0, of either sign", 0.0},
          {"even_exponential", "N/m", Role::scale, Range::any(),
           "stiffness k_h of the even exponential, of either sign", 0.0},
          {"exponential", "N/m", Role::scale, Range::any(),
           "stiffness k_e of the one-sided exponential, of either sign", 0.0},
          {"exponential_scale", "m", Role::shape, Range::any(),
           "displacement s over which the exponentials grow by a factor of e; negative: they grow towards negative z; "
           "0: no exponentials",
           0.0}},
         [](const ElementDescription& description) -> ElementPointer {
           const double scale = description.value("exponential_scale");
           const AsymmetricStiffness::Exponentials exponentials{description.value("exponential"),
                                                                description.value("even_exponential"), scale};
           if (scale == 0.0 && (exponentials.one_sided != 0.0 || exponentials.even != 0.0)) {
             refuseValue(description.type, "exponential_scale", scale, "m",
                         "a value other than 0 if an exponential is given");
           }
           return std::make_shared<const AsymmetricStiffness>(description.value("quadratic"),
                                                              description.value("tension_stiffness"), exponentials,
                                                              description.value("slope_difference"));
         }});

}  // namespace
}  // namespace rubber_suspension::element
