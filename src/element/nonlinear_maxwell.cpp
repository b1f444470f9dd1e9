// Maxwell element whose dashpot yields to large forces.
#include "rubber_suspension/element/nonlinear_maxwell.h"

#include <cmath>

namespace rubber_suspension::element {

// dF/dt = -F/tau (|F|/(k y))^p has |F|^-p grow by p/(tau (k y)^p) a second.
double NonlinearMaxwell::yielded(double force, double relaxation_times) const {
  const double share = std::abs(force) / force_;
  if (power_ == 1.0) {
    return force / (1.0 + relaxation_times * share);
  }
  if (power_ == 3.0) {  // the same as below in half of the time
    return force / std::cbrt(1.0 + 3.0 * relaxation_times * share * share * share);
  }
  return force * std::pow(1.0 + power_ * relaxation_times * std::pow(share, power_), -1.0 / power_);
}

double NonlinearMaxwell::step(const Motion& motion, double* memory) const {
  const double half = 0.5 * motion.dt * linear_.rate();
  memory[0] = yielded(memory[0], half);
  linear_.step(motion, memory);
  return memory[0] = yielded(memory[0], half);
}

ElementType nonlinearMaxwellType() {
  return {"nonlinear_maxwell",
          "Maxwell element whose dashpot yields, dF/dt = k dz/dt - 2 pi f_b F (1 + (|F|/(k y))^p): rate and amplitude "
          "dependence that are coupled.",
          {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k of the spring"},
           {"break_frequency", "Hz", Role::shape, Range::positive(), "break frequency f_b at small amplitude"},
           {"displacement", "m", Role::shape, Range::positive(), "displacement y at which the dashpot yields"},
           {"power", "1", Role::choice, Range::closed(0.5, 10.0),
            "p; the larger, the more y is a limit of the spring's displacement", 1.0}},
          makes<NonlinearMaxwell>("stiffness", "break_frequency", "displacement", "power")};
}

}  // namespace rubber_suspension::element
