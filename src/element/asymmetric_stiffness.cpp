// Even part of a characteristic.
#include "rubber_suspension/element/asymmetric_stiffness.h"

namespace rubber_suspension {

ElementType asymmetricStiffnessType() {
  return {"asymmetric_stiffness",
          "Different stiffness in the two directions: F = k2 z^2 + k_t max(z, 0), on top of a linear spring.",
          {{"quadratic", "N/m^2", Range::any(), 0.0, "coefficient k2, of either sign"},
           {"tension_stiffness", "N/m", Range::any(), 0.0, "extra stiffness k_t at z > 0, of either sign"}},
          [](const ElementDescription& description) -> ElementPointer {
            return std::make_shared<const AsymmetricStiffness>(description.value("quadratic"),
                                                               description.value("tension_stiffness"));
          }};
}

}  // namespace rubber_suspension
