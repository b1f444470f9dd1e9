// Maxwell element whose dashpot yields at large forces: coupled dependence on rate and amplitude.
#include <cmath>

#include "element/registry.h"
#include "rubber_suspension/element/maxwell.h"

namespace rubber_suspension::element {
namespace {

/// Simulates dF/dt = k dz/dt - F/tau (1 + (|F|/(k y))^p), tau = 1/(2 pi f_b), which is a Maxwell element while its
/// spring is deflected by much less than y. At larger deflections the element relaxes faster as its force grows. The
/// larger the power p, the more sharply y limits the deflection. So the stiffness falls with amplitude, but only at
/// frequencies at which the element contributes, which friction in parallel with a Maxwell element cannot reproduce.
/// For a given y the force is proportional to k.
///
/// The step is a symmetric splitting: half of the nonlinear relaxation, the exact linear step, the other half. It is
/// exact in the limit of a large y, otherwise of second order in dt/tau (|F|/(k y))^p, and dissipative at any step
/// length. Memory: the force. Source: flow that is activated by stress, J. S. Bergstrom and M. C. Boyce, J. Mech. Phys.
/// Solids 46 (1998) 931-954, in one dimension and with a linear part added; p + 1 is their power m.
class NonlinearMaxwell final : public ParallelElement {
 public:
  NonlinearMaxwell(double stiffness /* k [N/m] */, double break_frequency /* f_b [Hz] */,
                   double displacement /* y [m] */, double power /* p [-] */)
      : linear_(stiffness, break_frequency), force_(stiffness * displacement), power_(power) {}

  std::size_t memorySize() const override { return linear_.memorySize(); }
  double step(const Motion& motion, double* memory) const override {
    const double half = 0.5 * motion.dt * linear_.rate();
    memory[0] = yielded(memory[0], half);
    linear_.step(motion, memory);
    return memory[0] = yielded(memory[0], half);
  }
  Part part() const override { return Part::viscous; }

 private:
  // Returns the force after dF/dt = -F/tau (|F|/(k y))^p, in which |F|^-p grows at the constant rate p/(tau (k y)^p).
  double yielded(double force, double relaxation_times) const {
    const double share = std::abs(force) / force_;
    if (power_ == 1.0) {
      return force / (1.0 + relaxation_times * share);
    }
    if (power_ == 3.0) {  // the same as the general formula, computed in half the time
      return force / std::cbrt(1.0 + 3.0 * relaxation_times * share * share * share);
    }
    return force * std::pow(1.0 + power_ * relaxation_times * std::pow(share, power_), -1.0 / power_);
  }

  Maxwell linear_;
  double force_;  // k y [N]
  double power_;
};

const ElementEntry kNonlinearMaxwellEntry(
    120, {"nonlinear_maxwell",
          "Maxwell element whose dashpot yields, dF/dt = k dz/dt - 2 pi f_b F (1 + (|F|/(k y))^p): coupled dependence "
          "on rate and amplitude.",
          {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k of the spring"},
           {"break_frequency", "Hz", Role::shape, Range::positive(), "break frequency f_b at small amplitude"},
           {"displacement", "m", Role::shape, Range::positive(), "displacement y at which the dashpot yields"},
           {"power", "1", Role::choice, Range::closed(0.5, 10.0),
            "exponent p; the larger, the sharper y limits the displacement of the spring", 1.0}},
          makes<NonlinearMaxwell>("stiffness", "break_frequency", "displacement", "power")});

}  // namespace
}  // namespace rubber_suspension::element
