// Self-heating: the loss of the rubber warms and softens it.
#include <algorithm>

#include "element/registry.h"
#include "rubber_suspension/element/relaxation.h"

namespace rubber_suspension::element {
namespace {

enum HeatSlot { kRise, kLossForce };

// Bounds x far beyond the largest softening, so that x is finite for any displacement.
constexpr double kLargestRise = 1e6;

constexpr double kLeastFactor = 0.2;

double factorAt(double rise) { return std::clamp(1.0 - rise, kLeastFactor, 1.0); }

/// Multiplies the force of the test piece by 1 - x, at least 0.2 and at most 1, with dx/dt = s P - x/T.
/// x is the temperature rise times the relative softening per kelvin. P is the power absorbed by the softened viscous
/// and friction forces. s = (softening per kelvin)/(heat capacity), T = (heat capacity)/(heat transfer coefficient). In
/// steady operation x tends to s T (mean P). Stiffness and loss are multiplied by the same factor. Each step uses the
/// mean of the forces at its start and end, and the exact decay of x. Validity: one temperature for the whole test
/// piece; the ambient temperature and the shift of frequencies are neglected. Memory: x, and the viscous plus friction
/// force of the last step. Source: lumped heat balance, e.g. A. R. Johnson and T.-K. Chen, Comput. Methods Appl. Mech.
/// Eng. 194 (2005) 313-325.
class SelfHeating final : public ForceEffect {
 public:
  SelfHeating(double energy_sensitivity /* s [1/J] */, double time_constant /* T [s] */)
      : energy_sensitivity_(energy_sensitivity), time_constant_(time_constant) {}

  std::size_t memorySize() const override { return 2; }
  void initialise(double /*displacement*/, double* memory) const override { memory[kRise] = memory[kLossForce] = 0.0; }
  double step(const Motion& motion, const ComponentForce& force, double* memory) const override {
    const double loss_force = force.viscous + force.friction;
    const double mean_force = 0.5 * (loss_force + memory[kLossForce]) * factorAt(memory[kRise]);
    const Relaxation cooling = Relaxation::over(motion.dt / time_constant_);
    const double heating = energy_sensitivity_ * mean_force * motion.increment;
    // If the power is constant over the step, the new x is x e + s P T (1 - e) with e = exp(-dt/T).
    const double rise = memory[kRise] * cooling.decay + heating * cooling.mean;
    memory[kRise] = std::clamp(rise, -kLargestRise, kLargestRise);
    memory[kLossForce] = loss_force;
    return factorAt(memory[kRise]);
  }
  bool passive() const override { return false; }

 private:
  double energy_sensitivity_;
  double time_constant_;
};

const ElementEntry kSelfHeatingEntry(
    340,
    {"self_heating",
     "Softening by heat from the component's own loss: stiffness falls slowly under large motion and recovers at rest.",
     {{"energy_sensitivity", "1/J", Role::shape, Range::positive(), "relative softening per energy lost"},
      {"time_constant", "s", Role::shape, Range::positive(), "time constant of cooling"}},
     makes<SelfHeating>("energy_sensitivity", "time_constant")});

}  // namespace
}  // namespace rubber_suspension::element
