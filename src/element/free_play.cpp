// Free play.
#include "rubber_suspension/element/free_play.h"

namespace rubber_suspension::element {

ElementType freePlayType() {
  return {"free_play",
          "Dead zone of displacement in which the test piece does not move.",
          {{"gap", "m", Role::shape, Range::positive(), "width g of the dead zone to either side of zero"},
           {"share", "1", Role::shape, Range::openBelow(0.0, 1.0), "part s of the motion within the gap that is lost",
            1.0}},
          makes<FreePlay>("gap", "share")};
}

}  // namespace rubber_suspension::element
