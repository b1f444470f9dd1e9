// Maxwell element with a stiffness that motion breaks down.
#include "rubber_suspension/element/thixotropic_maxwell.h"

#include <algorithm>
#include <cmath>

#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/relaxation.h"
#include "rubber_suspension/element/structure_state.h"

namespace rubber_suspension::element {
namespace {

enum ThixotropicSlot { kForce, kStructure };

// Integral over a step of dt of exp(-a t) exp(-b (dt - t)): the difference of two relaxations over that of their rates.
double overlap(double a, double b, double dt) {
  return std::exp(-std::min(a, b) * dt) * dt * Relaxation::over(std::abs(a - b) * dt).mean;
}

}  // namespace

ThixotropicMaxwell::ThixotropicMaxwell(const Parameters& parameters)
    : parameters_(parameters), rate_(2.0 * kPi * parameters.break_frequency) {}

double ThixotropicMaxwell::initialise(double /*displacement*/, double* memory) const {
  memory[kForce] = 0.0;
  memory[kStructure] = 1.0;
  return 0.0;
}

double ThixotropicMaxwell::step(const Motion& motion, double* memory) const {
  const StructureState state(motion, parameters_.build_up_time, parameters_.travel);
  const Relaxation relaxation = Relaxation::over(motion.dt * rate_);
  const double velocity = motion.increment / motion.dt;
  const double built = state.settled * motion.increment * relaxation.mean +
                       (memory[kStructure] - state.settled) * velocity * overlap(state.rate, rate_, motion.dt);
  memory[kForce] = relaxation.decay * memory[kForce] + parameters_.stiffness * built;
  memory[kStructure] = state.after(memory[kStructure]);
  return memory[kForce];
}

ElementType thixotropicMaxwellType() {
  return {
      "thixotropic_maxwell",
      "Maxwell element whose stiffness k m breaks down with motion and builds up at rest, dm/dt = (1 - m)/T_b - m "
      "|dz/dt|/s: rate and amplitude dependence that are coupled.",
      {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k of the unbroken structure"},
       {"break_frequency", "Hz", Role::shape, Range::positive(), "break frequency f_b"},
       {"build_up_time", "s", Role::shape, Range::positive(), "time T_b over which the structure builds up at rest"},
       {"travel", "m", Role::shape, Range::positive(), "travel s over which motion breaks it by e"}},
      makes<ThixotropicMaxwell, ThixotropicMaxwell::Parameters>("stiffness", "break_frequency", "build_up_time",
                                                                "travel")};
}

}  // namespace rubber_suspension::element
