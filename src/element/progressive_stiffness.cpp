// Odd stiffening spring.
#include "rubber_suspension/element/progressive_stiffness.h"

#include <algorithm>

namespace rubber_suspension::element {

double ProgressiveStiffness::stiffening(double displacement) const {
  constexpr double kSteepest = 20.0;
  const double strain = std::abs(displacement) / scale_;
  const double bounded = std::min(strain, kSteepest);
  const double growth = std::sinh(bounded) - bounded + (strain - bounded) * (std::cosh(bounded) - 1.0);
  return std::copysign(exponential_ * scale_ * growth, displacement);
}

ElementType progressiveStiffnessType() {
  return {"progressive_stiffness",
          "Stiffness that rises with amplitude: F = k2 z|z| + k3 z^3 + k5 z^5 + k_e (s sinh(z/s) - z), on "
          "top of a linear spring.",
          {{"quadratic", "N/m^2", Role::scale, Range::nonNegative(),
            "coefficient k2 of z|z|; one of the coefficients must be greater than 0", 0.0},
           {"cubic", "N/m^3", Role::scale, Range::nonNegative(), "coefficient k3", 0.0},
           {"quintic", "N/m^5", Role::scale, Range::nonNegative(), "coefficient k5", 0.0},
           {"exponential", "N/m", Role::scale, Range::nonNegative(), "stiffness k_e of the exponential", 0.0},
           {"exponential_scale", "m", Role::shape, Range::nonNegative(),
            "displacement s over which it grows by e; 0: no exponential", 0.0}},
          [](const ElementDescription& description) -> ElementPointer {
            const double quadratic = description.value("quadratic");
            const double cubic = description.value("cubic");
            const double quintic = description.value("quintic");
            const double exponential = description.value("exponential");
            const double scale = description.value("exponential_scale");
            if (quadratic == 0.0 && cubic == 0.0 && quintic == 0.0 && exponential == 0.0) {
              refuseValue(description.type, "cubic", cubic, "N/m^3",
                          "greater than 0, or else quadratic, quintic or exponential greater than 0");
            }
            if (scale == 0.0 && exponential != 0.0) {
              refuseValue(description.type, "exponential_scale", scale, "m", "greater than 0 beside an exponential");
            }
            return std::make_shared<const ProgressiveStiffness>(cubic, quintic, quadratic, exponential, scale);
          }};
}

}  // namespace rubber_suspension::element
