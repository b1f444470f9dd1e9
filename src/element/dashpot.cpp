// Linear dashpot.
#include "rubber_suspension/element/dashpot.h"

namespace rubber_suspension {

ElementType dashpotType() {
  return {"dashpot",
          "Linear dashpot, F = c dz/dt.",
          {{"damping", "N s/m", Range::positive(), std::nullopt, "damping constant c"}},
          [](const ElementDescription& description) -> ElementPointer {
            return std::make_shared<const Dashpot>(description.value("damping"));
          }};
}

}  // namespace rubber_suspension
