// Flow beyond a limit of the force.
#include "rubber_suspension/element/overstress.h"

#include <cmath>

#include "rubber_suspension/element/implicit_flow.h"

namespace rubber_suspension::element {

// Memory: the spring's displacement in units of y.
double Overstress::step(const Motion& motion, double* memory) const {
  const Parameters& p = parameters_;
  const double target = memory[0] + motion.increment / p.yield_displacement;
  const double beyond = std::abs(target) - 1.0;
  memory[0] =
      beyond <= 0.0
          ? target
          : std::copysign(1.0 + flowRoot(beyond, p.reference_rate * motion.dt / p.yield_displacement, p.power), target);
  return p.stiffness * p.yield_displacement * memory[0];
}

ElementType overstressType() {
  return {
      "overstress",
      "Spring that flows beyond a limit of its force, the faster the farther beyond: F = k y (1 + (v/v_r)^(1/m)) at "
      "a steady rate v, k y after a hold.",
      {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k of the spring"},
       {"yield_displacement", "m", Role::shape, Range::positive(), "displacement y of the spring at the limit k y"},
       {"reference_rate", "m/s", Role::shape, Range::positive(), "rate v_r that doubles the force in flow"},
       {"power", "1", Role::shape, Range::closed(0.25, 10.0), "m, by which what is beyond the limit flows", 2.0}},
      makes<Overstress, Overstress::Parameters>("stiffness", "yield_displacement", "reference_rate", "power")};
}

}  // namespace rubber_suspension::element
