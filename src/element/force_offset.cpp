// Constant force.
#include "rubber_suspension/element/force_offset.h"

namespace rubber_suspension::element {

ElementType forceOffsetType() {
  return {"force_offset",
          "Constant force: zero error of the load cell, or a preload.",
          {{"offset", "N", Role::scale, Range::any(), std::nullopt, "force at zero displacement, of either sign"}},
          [](const ElementDescription& description) -> ElementPointer {
            return std::make_shared<const ForceOffset>(description.value("offset"));
          }};
}

}  // namespace rubber_suspension::element
