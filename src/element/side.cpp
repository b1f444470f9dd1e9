// The parameter `side`, checked.
#include "element/side.h"

#include <fmt/format.h>

namespace rubber_suspension::element {

int sideOf(const ElementDescription& description, const char* quantity) {
  const double side = description.value("side");
  if (side != -1.0 && side != 0.0 && side != 1.0) {
    refuseValue(description.type, "side", side, "1",
                fmt::format("1 ({0} > 0 only), -1 ({0} < 0 only) or 0 (both)", quantity));
  }
  return static_cast<int>(side);
}

}  // namespace rubber_suspension::element
