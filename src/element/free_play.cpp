// Free play.
#include "rubber_suspension/element/free_play.h"

namespace rubber_suspension {

ElementType freePlayType() {
  return {"free_play",
          "Dead zone of displacement in which the specimen is not moved.",
          {{"gap", "m", Range::positive(), std::nullopt, "width g of the dead zone to either side of zero"}},
          [](const ElementDescription& description) -> ElementPointer {
            return std::make_shared<const FreePlay>(description.value("gap"));
          }};
}

}  // namespace rubber_suspension
