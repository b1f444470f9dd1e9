// Maxwell element whose dashpot yields to large forces.
#include "rubber_suspension/element/nonlinear_maxwell.h"

namespace rubber_suspension::element {

double NonlinearMaxwell::step(const Motion& motion, double* memory) const {
  const double half = 0.5 * motion.dt * linear_.rate() / force_;
  memory[0] /= 1.0 + half * std::abs(memory[0]);  // dF/dt = -F |F|/(tau k y)
  linear_.step(motion, memory);
  return memory[0] /= 1.0 + half * std::abs(memory[0]);
}

ElementType nonlinearMaxwellType() {
  return {"nonlinear_maxwell",
          "Maxwell element whose dashpot yields, dF/dt = k dz/dt - 2 pi f_b F (1 + |F|/(k y)): rate and amplitude "
          "dependence that are coupled.",
          {{"stiffness", "N/m", Role::scale, Range::positive(), std::nullopt, "stiffness k of the spring"},
           {"break_frequency", "Hz", Role::shape, Range::positive(), std::nullopt,
            "break frequency f_b at small amplitude"},
           {"displacement", "m", Role::shape, Range::positive(), std::nullopt,
            "displacement y at which the dashpot yields"}},
          [](const ElementDescription& description) -> ElementPointer {
            return std::make_shared<const NonlinearMaxwell>(description.value("stiffness"),
                                                            description.value("break_frequency"),
                                                            description.value("displacement"));
          }};
}

}  // namespace rubber_suspension::element
