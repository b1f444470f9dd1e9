// Friction behind a play.
#include "rubber_suspension/element/friction_behind_play.h"

#include <algorithm>

namespace rubber_suspension::element {

double FrictionBehindPlay::initialise(double displacement, double* memory) const {
  memory[0] = displacement;
  return 0.0;
}

double FrictionBehindPlay::step(const Motion& motion, double* memory) const {
  const double reach = gap_ + yield_displacement_;
  memory[0] = std::clamp(memory[0], motion.displacement - reach, motion.displacement + reach);
  const double offset = motion.displacement - memory[0];
  return stiffness_ * (offset - std::clamp(offset, -gap_, gap_));
}

ElementType frictionBehindPlayType() {
  return {"friction_behind_play",
          "Friction behind a clearance of its own: missing over 2 g of travel after each reversal.",
          {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k while it sticks"},
           {"yield_displacement", "m", Role::shape, Range::positive(),
            "displacement y beyond the clearance at which it slides"},
           {"gap", "m", Role::shape, Range::positive(), "clearance g to either side"}},
          makes<FrictionBehindPlay>("stiffness", "yield_displacement", "gap")};
}

}  // namespace rubber_suspension::element
