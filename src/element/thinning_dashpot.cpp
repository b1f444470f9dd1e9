// Dashpot that thins under shear.
#include "rubber_suspension/element/thinning_dashpot.h"

namespace rubber_suspension::element {

ElementType thinningDashpotType() {
  return {"thinning_dashpot",
          "Dashpot that thins under shear, F = c v/(1 + |v|/v_h), v = dz/dt: c v_h at most.",
          {{"damping", "N s/m", Role::scale, Range::positive(), "damping constant c at slow motion"},
           {"half_rate", "m/s", Role::shape, Range::positive(), "rate v_h at half of the damping"}},
          makes<ThinningDashpot>("damping", "half_rate")};
}

}  // namespace rubber_suspension::element
