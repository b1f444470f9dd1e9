// Maxwell element.
#include "rubber_suspension/element/maxwell.h"

#include "element/registry.h"

namespace rubber_suspension::element {

namespace {

const ElementEntry kMaxwellEntry(
    110, {"maxwell",
          "Maxwell element: spring k and dashpot c = k/(2 pi f_b) in series.",
          {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k of the spring"},
           {"break_frequency", "Hz", Role::shape, Range::positive(), "break frequency f_b = k/(2 pi c)"}},
          makes<Maxwell>("stiffness", "break_frequency")});

}  // namespace
}  // namespace rubber_suspension::element
