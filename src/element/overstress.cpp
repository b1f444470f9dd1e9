// Spring that flows beyond a limit of its force, at a rate that grows with the excess.
#include <cmath>

#include "element/implicit_flow.h"
#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

/// Simulates dF/dt = k (dz/dt - v_r sign(F) max(0, |F|/(k y) - 1)^m), which is elastic up to the limit k y. The force
/// is k y (1 + (v/v_r)^(1/m)) at a steady rate v, so for slow motion the law is a slider, and during a hold the force
/// relaxes to k y. So the amplitude dependence varies with the rate. The force is linear in k for given other
/// parameters.
///
/// The step is implicit Euler (flowRoot()), which is exact in steady flow, otherwise of first order, and dissipative at
/// any step length. Memory: the deflection of the spring divided by y. Source: overstress, P. Perzyna, Adv. Appl. Mech.
/// 9 (1966) 243-377; for elastomers with an equilibrium hysteresis P. Haupt and K. Sedlan, Arch. Appl. Mech. 71 (2001)
/// 89-109.
class Overstress final : public ParallelElement {
 public:
  struct Parameters {
    double stiffness;           // k [N/m]
    double yield_displacement;  // y [m]
    double reference_rate;      // v_r [m/s]
    double power;               // m [-]
  };

  explicit Overstress(const Parameters& parameters) : parameters_(parameters) {}

  std::size_t memorySize() const override { return 1; }

  double step(const Motion& motion, double* memory) const override {
    const Parameters& p = parameters_;
    const double target = memory[0] + motion.increment / p.yield_displacement;
    const double beyond = std::abs(target) - 1.0;
    memory[0] = beyond <= 0.0
                    ? target
                    : std::copysign(
                          1.0 + flowRoot(beyond, p.reference_rate * motion.dt / p.yield_displacement, p.power), target);
    return p.stiffness * p.yield_displacement * memory[0];
  }
  Part part() const override { return Part::friction; }

 private:
  Parameters parameters_;
};

const ElementEntry kOverstressEntry(
    300, {"overstress",
          "Spring that flows when its force exceeds k y; the flow is faster for a larger excess: F = k y (1 + "
          "(v/v_r)^(1/m)) at a steady rate v, F = k y after a hold.",
          {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k of the spring"},
           {"yield_displacement", "m", Role::shape, Range::positive(), "displacement y of the spring at the limit k y"},
           {"reference_rate", "m/s", Role::shape, Range::positive(), "rate v_r at which the force is 2 k y"},
           {"power", "1", Role::shape, Range::closed(0.25, 10.0),
            "exponent m: the rate of flow is proportional to the power m of the excess force", 2.0}},
          makes<Overstress, Overstress::Parameters>("stiffness", "yield_displacement", "reference_rate", "power")});

}  // namespace
}  // namespace rubber_suspension::element
