// Maxwell element whose stiffness breaks down with motion and builds up at rest.
#include <algorithm>
#include <cmath>

#include "element/registry.h"
#include "element/structure_state.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/relaxation.h"

namespace rubber_suspension::element {
namespace {

enum ThixotropicSlot { kForce, kStructure };

// Integral over a step of dt of exp(-a t) exp(-b (dt - t)): the difference of two relaxations over that of their rates.
double overlap(double a, double b, double dt) {
  return std::exp(-std::min(a, b) * dt) * dt * Relaxation::over(std::abs(a - b) * dt).mean;
}

/// dF/dt = k m dz/dt - F/tau, dm/dt = (1 - m)/T_b - m |dz/dt|/s, tau = 1/(2 pi f_b): a Maxwell element that softens
/// with the rate of the motion (Payne effect) and recovers over T_b. In steady motion of mean speed v the state is
/// m = 1/(1 + v T_b/s), so the stiffness falls with amplitude times frequency; relaxation beside friction, a sum,
/// cannot do that. m depends on the displacement alone, so the force is linear in k.
///
/// Exact for a displacement that is linear over the step. Settled cycles dissipate; it is not passive in the strict
/// sense, because force that was built up while m was large is given back over the longer way of a small one. Validity:
/// beside a spring and other elements that carry most of the force. Memory: the force, m.
/// Source: P. Haupt, K. Sedlan, Arch. Appl. Mech. 71 (2001) 89-109; P. Hofer, A. Lion, J. Mech. Phys. Solids 57 (2009)
/// 500-520.
class ThixotropicMaxwell final : public ParallelElement {
 public:
  struct Parameters {
    double stiffness;        ///< k [N/m]
    double break_frequency;  ///< f_b [Hz]
    double build_up_time;    ///< T_b [s]
    double travel;           ///< s [m]
  };

  explicit ThixotropicMaxwell(const Parameters& parameters)
      : parameters_(parameters), rate_(2.0 * kPi * parameters.break_frequency) {}

  std::size_t memorySize() const override { return 2; }
  double initialise(double /*displacement*/, double* memory) const override {
    memory[kForce] = 0.0;
    memory[kStructure] = 1.0;
    return 0.0;
  }

  double step(const Motion& motion, double* memory) const override {
    const StructureState state(motion, parameters_.build_up_time, parameters_.travel);
    const Relaxation relaxation = Relaxation::over(motion.dt * rate_);
    const double velocity = motion.increment / motion.dt;
    const double built = state.settled * motion.increment * relaxation.mean +
                         (memory[kStructure] - state.settled) * velocity * overlap(state.rate, rate_, motion.dt);
    memory[kForce] = relaxation.decay * memory[kForce] + parameters_.stiffness * built;
    memory[kStructure] = state.after(memory[kStructure]);
    return memory[kForce];
  }
  Part part() const override { return Part::viscous; }
  bool passive() const override { return false; }

 private:
  Parameters parameters_;
  double rate_;  // 1/tau [1/s]
};

const ElementEntry kThixotropicMaxwellEntry(
    140,
    {"thixotropic_maxwell",
     "Maxwell element whose stiffness k m breaks down with motion and builds up at rest, dm/dt = (1 - m)/T_b - m "
     "|dz/dt|/s: rate and amplitude dependence that are coupled.",
     {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k of the unbroken structure"},
      {"break_frequency", "Hz", Role::shape, Range::positive(), "break frequency f_b"},
      {"build_up_time", "s", Role::shape, Range::positive(), "time T_b over which the structure builds up at rest"},
      {"travel", "m", Role::shape, Range::positive(), "travel s over which motion breaks it by e"}},
     makes<ThixotropicMaxwell, ThixotropicMaxwell::Parameters>("stiffness", "break_frequency", "build_up_time",
                                                               "travel")});

}  // namespace
}  // namespace rubber_suspension::element
