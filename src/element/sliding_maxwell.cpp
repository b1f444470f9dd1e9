// Maxwell element with a slider: it relaxes while its force is below a limit and slides at this limit.
#include <algorithm>

#include "element/registry.h"
#include "rubber_suspension/element/maxwell.h"

namespace rubber_suspension::element {
namespace {

/// Simulates dF/dt = k dz/dt - F/tau, tau = 1/(2 pi f_b), with |F| limited to k y. Well below the break frequency f_b
/// the element relaxes before it slides; above f_b it slides at amplitudes beyond y. So the stiffness falls with
/// amplitude at high frequency only. For a given y the force is proportional to k.
///
/// For a displacement that is linear between samples the force is monotonic over a step, so clamping it at the end of
/// the step is exact. The law dissipates. Memory: the force. Source: J. F. Besseling, J. Appl. Mech. 25 (1958) 529-536
/// (sublayers that yield); as an overlay model of rubber: P.-E. Austrell, A. K. Olsson, Polymer Testing 32 (2013)
/// 306-312.
class SlidingMaxwell final : public ParallelElement {
 public:
  SlidingMaxwell(double stiffness /* k [N/m] */, double break_frequency /* f_b [Hz] */,
                 double yield_displacement /* y [m] */)
      : linear_(stiffness, break_frequency), limit_(stiffness * yield_displacement) {}

  std::size_t memorySize() const override { return linear_.memorySize(); }
  double step(const Motion& motion, double* memory) const override {
    return memory[0] = std::clamp(linear_.step(motion, memory), -limit_, limit_);
  }
  Part part() const override { return Part::viscous; }

 private:
  Maxwell linear_;
  double limit_;  // k y [N]
};

const ElementEntry kSlidingMaxwellEntry(
    130, {"sliding_maxwell",
          "Maxwell element with a slider, dF/dt = k dz/dt - 2 pi f_b F and |F| <= k y: coupled dependence on rate and "
          "amplitude.",
          {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k of the spring"},
           {"break_frequency", "Hz", Role::shape, Range::positive(), "break frequency f_b"},
           {"yield_displacement", "m", Role::shape, Range::positive(),
            "displacement y of the spring at which the slider slides"}},
          makes<SlidingMaxwell>("stiffness", "break_frequency", "yield_displacement")});

}  // namespace
}  // namespace rubber_suspension::element
