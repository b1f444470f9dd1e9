// Linear spring.
#include "rubber_suspension/element/spring.h"

namespace rubber_suspension::element {

ElementType springType() {
  return {"spring",
          "Linear spring, F = k z.",
          {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k"}},
          makes<Spring>("stiffness")};
}

}  // namespace rubber_suspension::element
