// Linear spring.
#include "rubber_suspension/element/spring.h"

namespace rubber_suspension::element {

ElementType springType() {
  return {"spring",
          "Linear spring, F = k z.",
          {{"stiffness", "N/m", Role::scale, Range::positive(), std::nullopt, "stiffness k"}},
          [](const ElementDescription& description) -> ElementPointer {
            return std::make_shared<const Spring>(description.value("stiffness"));
          }};
}

}  // namespace rubber_suspension::element
