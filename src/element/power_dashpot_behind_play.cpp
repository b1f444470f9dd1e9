// Hydraulic damper in a worn eye.
#include "rubber_suspension/element/power_dashpot_behind_play.h"

#include <cmath>

#include "rubber_suspension/element/implicit_flow.h"

namespace rubber_suspension::element {

double PowerDashpotBehindPlay::initialise(double displacement, double* memory) const {
  memory[0] = displacement;
  return 0.0;
}

double PowerDashpotBehindPlay::step(const Motion& motion, double* memory) const {
  const Parameters& p = parameters_;
  const double offset = motion.displacement - memory[0];
  const double depth = std::abs(offset) - p.gap;  // without flow
  if (depth <= 0.0) {
    return 0.0;
  }
  const double way = std::abs(motion.increment);
  const double contact = way > depth ? depth / way : 1.0;  // share of the step
  const double flow = p.reference_rate * contact * motion.dt / p.displacement;
  const double left = p.displacement * flowRoot(depth / p.displacement, flow, 1.0 / p.exponent);
  memory[0] = motion.displacement - std::copysign(p.gap + left, offset);
  return std::copysign(p.stiffness * left, offset);
}

ElementType powerDashpotBehindPlayType() {
  return {
      "power_dashpot_behind_play",
      "Spring and dashpot of any power in series behind a clearance of their own: a hydraulic damper in a worn eye, "
      "F = k y (v/v_r)^p in steady flow.",
      {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k of the spring"},
       {"displacement", "m", Role::shape, Range::positive(), "displacement y of the spring in flow at the rate v_r"},
       {"reference_rate", "m/s", Role::shape, Range::positive(), "rate v_r"},
       {"exponent", "1", Role::shape, Range::closed(0.1, 4.0), "power p; 1: a linear dashpot"},
       {"gap", "m", Role::shape, Range::positive(), "clearance g to either side"}},
      makes<PowerDashpotBehindPlay, PowerDashpotBehindPlay::Parameters>("stiffness", "displacement", "reference_rate",
                                                                        "exponent", "gap")};
}

}  // namespace rubber_suspension::element
