// Maxwell element with a slider.
#include "rubber_suspension/element/sliding_maxwell.h"

namespace rubber_suspension::element {

ElementType slidingMaxwellType() {
  return {
      "sliding_maxwell",
      "Maxwell element with a slider, dF/dt = k dz/dt - 2 pi f_b F and |F| <= k y: rate and amplitude dependence "
      "that are coupled.",
      {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k of the spring"},
       {"break_frequency", "Hz", Role::shape, Range::positive(), "break frequency f_b"},
       {"yield_displacement", "m", Role::shape, Range::positive(), "displacement y of the spring at which it slides"}},
      makes<SlidingMaxwell>("stiffness", "break_frequency", "yield_displacement")};
}

}  // namespace rubber_suspension::element
