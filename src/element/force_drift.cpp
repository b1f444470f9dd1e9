// Force that grows with time.
#include "rubber_suspension/element/force_drift.h"

namespace rubber_suspension::element {

ElementType forceDriftType() {
  return {"force_drift",
          "Force that grows with time: drift of the load cell.",
          {{"rate", "N/s", Role::scale, Range::any(), "growth of the force per time, of either sign"}},
          makes<ForceDrift>("rate")};
}

}  // namespace rubber_suspension::element
