// Constant force.
#include "rubber_suspension/element/force_offset.h"

namespace rubber_suspension::element {

ElementType forceOffsetType() {
  return {"force_offset",
          "Constant force: zero error of the load cell, or a preload.",
          {{"offset", "N", Role::scale, Range::any(), "force at zero displacement, of either sign"}},
          makes<ForceOffset>("offset")};
}

}  // namespace rubber_suspension::element
