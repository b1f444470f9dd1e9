// Linear dashpot.
#include "rubber_suspension/element/dashpot.h"

namespace rubber_suspension::element {

ElementType dashpotType() {
  return {"dashpot",
          "Linear dashpot, F = c dz/dt.",
          {{"damping", "N s/m", Role::scale, Range::positive(), "damping constant c"},
           {"order", "1", Role::choice, Range::closed(1.0, 2.0),
            "of the difference for the rate; 1: displacement linear between samples, 2: smooth, without lag", 1.0}},
          [](const ElementDescription& description) -> ElementPointer {
            const double damping = description.value("damping");
            const double order = description.value("order");
            if (order == 2.0) {
              return std::make_shared<const SmoothDashpot>(damping);
            }
            if (order != 1.0) {
              refuseValue(description.type, "order", order, "1", "1 or 2");
            }
            return std::make_shared<const Dashpot>(damping);
          }};
}

}  // namespace rubber_suspension::element
