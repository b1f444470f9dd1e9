// Odd polynomial spring.
#include "rubber_suspension/element/progressive_stiffness.h"

namespace rubber_suspension {

ElementType progressiveStiffnessType() {
  return {"progressive_stiffness",
          "Stiffness that rises with amplitude: F = k2 z|z| + k3 z^3 + k5 z^5, on top of a linear spring.",
          {{"quadratic", "N/m^2", Range::nonNegative(), 0.0,
            "coefficient k2 of z|z|; one of the three must be greater than 0"},
           {"cubic", "N/m^3", Range::nonNegative(), 0.0, "coefficient k3"},
           {"quintic", "N/m^5", Range::nonNegative(), 0.0, "coefficient k5"}},
          [](const ElementDescription& description) -> ElementPointer {
            const double quadratic = description.value("quadratic");
            const double cubic = description.value("cubic");
            const double quintic = description.value("quintic");
            if (quadratic == 0.0 && cubic == 0.0 && quintic == 0.0) {
              refuseValue(description.type, "cubic", cubic, "N/m^3",
                          "greater than 0, or else quadratic or quintic greater than 0");
            }
            return std::make_shared<const ProgressiveStiffness>(cubic, quintic, quadratic);
          }};
}

}  // namespace rubber_suspension
