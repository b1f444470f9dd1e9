// Self-heating.
#include "rubber_suspension/element/self_heating.h"

#include <algorithm>

#include "rubber_suspension/element/relaxation.h"

namespace rubber_suspension::element {
namespace {

enum HeatSlot { kRise, kLossForce };

// Far beyond all that softens further; a displacement that no test piece survives must not leave an infinite rise.
constexpr double kLargestRise = 1e6;

double factorAt(double rise) { return std::clamp(1.0 - rise, SelfHeating::kLeastFactor, 1.0); }

}  // namespace

void SelfHeating::initialise(double /*displacement*/, double* memory) const {
  memory[kRise] = memory[kLossForce] = 0.0;
}

double SelfHeating::step(const Motion& motion, const ComponentForce& force, double* memory) const {
  const double loss_force = force.viscous + force.friction;
  const double mean_force = 0.5 * (loss_force + memory[kLossForce]) * factorAt(memory[kRise]);
  const Relaxation cooling = Relaxation::over(motion.dt / time_constant_);
  const double heating = energy_sensitivity_ * mean_force * motion.increment;
  // At constant power over the step: x+ = x e + s P T (1 - e).
  const double rise = memory[kRise] * cooling.decay + heating * cooling.mean;
  memory[kRise] = std::clamp(rise, -kLargestRise, kLargestRise);
  memory[kLossForce] = loss_force;
  return factorAt(memory[kRise]);
}

ElementType selfHeatingType() {
  return {
      "self_heating",
      "Softening by the heat of the component's own loss: stiffness falls slowly under hard work and recovers at rest.",
      {{"energy_sensitivity", "1/J", Role::shape, Range::positive(), "relative softening per energy lost"},
       {"time_constant", "s", Role::shape, Range::positive(), "time constant of cooling"}},
      makes<SelfHeating>("energy_sensitivity", "time_constant")};
}

}  // namespace rubber_suspension::element
