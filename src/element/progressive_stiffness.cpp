// Odd polynomial spring.
#include "rubber_suspension/element/progressive_stiffness.h"

namespace rubber_suspension {

ElementType progressiveStiffnessType() {
  return {"progressive_stiffness",
          "Stiffness that rises with amplitude: F = k3 z^3 + k5 z^5, on top of a linear spring.",
          {{"cubic", "N/m^3", Range::nonNegative(), 0.0, "coefficient k3; this or quintic must be greater than 0"},
           {"quintic", "N/m^5", Range::nonNegative(), 0.0, "coefficient k5"}},
          [](const ElementDescription& description) -> ElementPointer {
            const double cubic = description.value("cubic");
            const double quintic = description.value("quintic");
            if (cubic == 0.0 && quintic == 0.0) {
              refuseValue(description.type, "cubic", cubic, "N/m^3", "greater than 0, or else quintic greater than 0");
            }
            return std::make_shared<const ProgressiveStiffness>(cubic, quintic);
          }};
}

}  // namespace rubber_suspension
