// Even part of a characteristic.
#include "rubber_suspension/element/asymmetric_stiffness.h"

#include <algorithm>
#include <cmath>

namespace rubber_suspension::element {

double AsymmetricStiffness::stiffening(double displacement) const {
  constexpr double kSteepest = 20.0;
  const double strain = displacement / scale_;
  const double bounded = std::min(strain, kSteepest);
  const double growth = std::expm1(bounded) - bounded + (strain - bounded) * std::expm1(bounded);
  return exponential_ * scale_ * growth;
}

ElementType asymmetricStiffnessType() {
  return {"asymmetric_stiffness",
          "Different stiffness in the two directions: F = k2 z^2 + k_t max(z, 0) + k_e (s (exp(z/s) - 1) - z), "
          "on top of a linear spring.",
          {{"quadratic", "N/m^2", Role::scale, Range::any(), 0.0, "coefficient k2, of either sign"},
           {"tension_stiffness", "N/m", Role::scale, Range::any(), 0.0, "extra stiffness k_t at z > 0, of either sign"},
           {"exponential", "N/m", Role::scale, Range::any(), 0.0, "stiffness k_e of the exponential, of either sign"},
           {"exponential_scale", "m", Role::shape, Range::any(), 0.0,
            "displacement s over which it grows by e; negative: towards negative z; 0: no exponential"}},
          [](const ElementDescription& description) -> ElementPointer {
            const double scale = description.value("exponential_scale");
            if (scale == 0.0 && description.value("exponential") != 0.0) {
              refuseValue(description.type, "exponential_scale", scale, "m", "not 0 beside an exponential");
            }
            return std::make_shared<const AsymmetricStiffness>(description.value("quadratic"),
                                                               description.value("tension_stiffness"),
                                                               description.value("exponential"), scale);
          }};
}

}  // namespace rubber_suspension::element
