// Even part of a characteristic.
#include "rubber_suspension/element/asymmetric_stiffness.h"

#include <algorithm>
#include <cmath>

namespace rubber_suspension::element {

namespace {

// exp(x) - 1 - x, continued along its tangent.
double growth(double strain) {
  constexpr double kSteepest = 20.0;
  const double bounded = std::min(strain, kSteepest);
  return std::expm1(bounded) - bounded + (strain - bounded) * std::expm1(bounded);
}

}  // namespace

double AsymmetricStiffness::stiffening(double displacement) const {
  const double scale = exponentials_.scale;
  const double upper = growth(displacement / scale);
  const double even = 0.5 * exponentials_.even * std::abs(scale) * (upper + growth(-displacement / scale));
  return exponentials_.one_sided * scale * upper + even;
}

ElementType asymmetricStiffnessType() {
  return {"asymmetric_stiffness",
          "Different stiffness in the two directions: F = k2 z^2 + k_d |z|/2 + k_h s (cosh(z/s) - 1) + "
          "k_t max(z, 0) + k_e (s (exp(z/s) - 1) - z), on top of a linear spring.",
          {{"quadratic", "N/m^2", Role::scale, Range::any(), "coefficient k2, of either sign", 0.0},
           {"slope_difference", "N/m", Role::scale, Range::any(),
            "stiffness k_d at z > 0 beyond that at z < 0, the mean of both kept; of either sign", 0.0},
           {"tension_stiffness", "N/m", Role::scale, Range::any(), "extra stiffness k_t at z > 0, of either sign", 0.0},
           {"even_exponential", "N/m", Role::scale, Range::any(),
            "stiffness k_h of the even exponential, of either sign", 0.0},
           {"exponential", "N/m", Role::scale, Range::any(),
            "stiffness k_e of the one-sided exponential, of either sign", 0.0},
           {"exponential_scale", "m", Role::shape, Range::any(),
            "displacement s over which they grow by e; negative: towards negative z; 0: no exponential", 0.0}},
          [](const ElementDescription& description) -> ElementPointer {
            const double scale = description.value("exponential_scale");
            const AsymmetricStiffness::Exponentials exponentials{description.value("exponential"),
                                                                 description.value("even_exponential"), scale};
            if (scale == 0.0 && (exponentials.one_sided != 0.0 || exponentials.even != 0.0)) {
              refuseValue(description.type, "exponential_scale", scale, "m", "not 0 beside an exponential");
            }
            return std::make_shared<const AsymmetricStiffness>(description.value("quadratic"),
                                                               description.value("tension_stiffness"), exponentials,
                                                               description.value("slope_difference"));
          }};
}

}  // namespace rubber_suspension::element
