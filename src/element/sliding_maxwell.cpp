// Maxwell element with a slider.
#include "rubber_suspension/element/sliding_maxwell.h"

namespace rubber_suspension::element {

ElementType slidingMaxwellType() {
  return {"sliding_maxwell",
          "Maxwell element with a slider, dF/dt = k dz/dt - 2 pi f_b F and |F| <= k y: rate and amplitude dependence "
          "that are coupled.",
          {{"stiffness", "N/m", Role::scale, Range::positive(), std::nullopt, "stiffness k of the spring"},
           {"break_frequency", "Hz", Role::shape, Range::positive(), std::nullopt, "break frequency f_b"},
           {"yield_displacement", "m", Role::shape, Range::positive(), std::nullopt,
            "displacement y of the spring at which it slides"}},
          [](const ElementDescription& description) -> ElementPointer {
            return std::make_shared<const SlidingMaxwell>(description.value("stiffness"),
                                                          description.value("break_frequency"),
                                                          description.value("yield_displacement"));
          }};
}

}  // namespace rubber_suspension::element
