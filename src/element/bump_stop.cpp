// Bump stop.
#include "rubber_suspension/element/bump_stop.h"

#include <cmath>

namespace rubber_suspension::element {

double BumpStop::force(double displacement) const {
  const double depth = std::abs(displacement) - gap_;
  const bool beside = (side_ == Side::upper && displacement < 0.0) || (side_ == Side::lower && displacement > 0.0);
  if (depth <= 0.0 || beside) {
    return 0.0;
  }
  const double progression = exponent_ == 1.0 ? 1.0 : std::pow(depth / reference_depth_, exponent_ - 1.0);
  return std::copysign(stiffness_ * depth * progression, displacement);
}

ElementType bumpStopType() {
  return {
      "bump_stop",
      "Bump stop: F = k_s d (d/d_ref)^(p-1) beyond a gap, d being the depth of contact.",
      {{"stiffness", "N/m", Role::scale, Range::positive(), "secant stiffness k_s at the reference depth"},
       {"gap", "m", Role::shape, Range::nonNegative(), "displacement at which the stop comes into contact"},
       {"exponent", "1", Role::shape, Range::closed(1.0, 3.0), "exponent p of the force over the depth; 1 is linear",
        1.0},
       {"reference_depth", "m", Role::reference, Range::positive(), "depth d_ref at which the stop has its stiffness",
        0.001},
       {"side", "1", Role::choice, Range::closed(-1.0, 1.0), "1: stop at z > 0 only, -1: at z < 0 only, 0: both", 0.0}},
      [](const ElementDescription& description) -> ElementPointer {
        return std::make_shared<const BumpStop>(description.value("stiffness"), description.value("gap"),
                                                description.value("exponent"), description.value("reference_depth"),
                                                static_cast<BumpStop::Side>(sideOf(description, "z")));
      }};
}

}  // namespace rubber_suspension::element
