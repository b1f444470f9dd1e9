// Dashpot whose damping grows towards one side.
#include "rubber_suspension/element/position_dashpot.h"

#include <algorithm>
#include <cmath>

namespace rubber_suspension::element {

double PositionDashpot::dampingAt(double displacement) const {
  return damping_ * std::pow(std::max(0.0, 0.5 * (1.0 + displacement / reference_)), power_);
}

ElementType positionDashpotType() {
  return {"position_dashpot",
          "Dashpot whose damping grows towards one side as a gap closes, F = c s^p dz/dt, s = (1 + side z/z_r)/2 or 0.",
          {{"damping", "N s/m", Role::scale, Range::positive(), "damping constant c at z_r on that side"},
           {"reference_displacement", "m", Role::shape, Range::positive(),
            "displacement z_r at which the damping holds; there is none at z_r on the other side"},
           {"power", "1", Role::shape, Range::closed(0.1, 20.0), "p; the larger, the later the damping grows"},
           {"side", "1", Role::choice, Range::closed(-1.0, 1.0), "1: grows towards z > 0, -1: towards z < 0", 1.0}},
          [](const ElementDescription& description) -> ElementPointer {
            const double towards = sideOf(description, "z", false) * description.value("reference_displacement");
            return std::make_shared<const PositionDashpot>(description.value("damping"), towards,
                                                           description.value("power"));
          }};
}

}  // namespace rubber_suspension::element
