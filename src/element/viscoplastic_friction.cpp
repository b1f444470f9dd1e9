// Friction that a rate brings to its limit.
#include "rubber_suspension/element/viscoplastic_friction.h"

#include <cmath>

namespace rubber_suspension::element {

// f + a f/(1 - |f|) = r with f = F/(k y), a = v_0 dt/y, r = f before + dz/y. f has the sign of r, and |f| is the
// smaller root of f^2 - (1 + a + |r|) f + |r| = 0; both root and discriminant (|r| - 1 + a)^2 + 4 a without
// cancellation.
double ViscoplasticFriction::step(const Motion& motion, double* memory) const {
  const double flow = half_rate_ * motion.dt / yield_displacement_;
  const double target = memory[0] + motion.increment / yield_displacement_;
  const double excess = std::abs(target) - 1.0 + flow;
  memory[0] = 2.0 * target / (2.0 + excess + std::sqrt(excess * excess + 4.0 * flow));
  return stiffness_ * yield_displacement_ * memory[0];
}

ElementType viscoplasticFrictionType() {
  return {"viscoplastic_friction",
          "Friction that a rate brings to its limit, dF/dt = k (dz/dt - v_0 F/(k y - |F|)): at a steady rate v, "
          "F = k y v/(v_0 + |v|).",
          {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k while it sticks"},
           {"yield_displacement", "m", Role::shape, Range::positive(),
            "displacement y of the spring at the limit k y of the force"},
           {"half_rate", "m/s", Role::shape, Range::positive(), "rate v_0 at half of the limit"}},
          makes<ViscoplasticFriction>("stiffness", "yield_displacement", "half_rate")};
}

}  // namespace rubber_suspension::element
