// Friction that approaches its limit with the rate: a spring in series with a dashpot whose force is limited.
#include <cmath>

#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

/// Simulates dF/dt = k (dz/dt - v_0 F/(k y - |F|)). At a steady rate v, F = k y v/(v_0 + |v|).
///
/// The force is half of the limit k y at the rate v_0. At rates far above v_0 the law is Coulomb's friction behind a
/// contact spring, which slides at the displacement y; for small forces it is a Maxwell element of tau = y/v_0. It
/// describes a fluid with a yield stress, as in a magnetorheological damper, and a seal on an oil film. For given y and
/// v_0 the force is proportional to k.
///
/// The step is implicit Euler in closed form and of first order in dt v_0/y. At any step length the force remains below
/// the limit and the step dissipates. Memory: the force divided by the limit. Source: the dashpot of M. M. Cross, J.
/// Colloid Sci. 20 (1965) 417-437, with exponent 1 and no damping at infinite rate; the same in series with a spring:
/// D. R. Gamota and F. E. Filisko, J. Rheol. 35 (1991) 399-425.
class ViscoplasticFriction final : public ParallelElement {
 public:
  ViscoplasticFriction(double stiffness /* k [N/m] */, double yield_displacement /* y [m] */,
                       double half_rate /* v_0 [m/s] */)
      : stiffness_(stiffness), yield_displacement_(yield_displacement), half_rate_(half_rate) {}

  std::size_t memorySize() const override { return 1; }

  // Solves f + a f/(1 - |f|) = r with f = F/(k y), a = v_0 dt/y and r = f_0 + dz/y, where f_0 is f before the step. f
  // has the sign of r, and |f| is the smaller root of f^2 - (1 + a + |r|) f + |r| = 0. The root and the discriminant
  // (|r| - 1 + a)^2 + 4 a are computed without cancellation.
  double step(const Motion& motion, double* memory) const override {
    const double flow = half_rate_ * motion.dt / yield_displacement_;
    const double target = memory[0] + motion.increment / yield_displacement_;
    const double excess = std::abs(target) - 1.0 + flow;
    memory[0] = 2.0 * target / (2.0 + excess + std::sqrt(excess * excess + 4.0 * flow));
    return stiffness_ * yield_displacement_ * memory[0];
  }
  Part part() const override { return Part::friction; }

 private:
  double stiffness_;
  double yield_displacement_;
  double half_rate_;
};

const ElementEntry kViscoplasticFrictionEntry(
    290, {"viscoplastic_friction",
          "Friction that approaches its limit k y with the rate, dF/dt = k (dz/dt - v_0 F/(k y - |F|)): at a steady "
          "rate v, F = k y v/(v_0 + |v|).",
          {{"stiffness", "N/m", Role::scale, Range::positive(), "stiffness k while the friction sticks"},
           {"yield_displacement", "m", Role::shape, Range::positive(),
            "displacement y of the spring at the limit k y of the force"},
           {"half_rate", "m/s", Role::shape, Range::positive(), "rate v_0 at which the force is half of the limit"}},
          makes<ViscoplasticFriction>("stiffness", "yield_displacement", "half_rate")});

}  // namespace
}  // namespace rubber_suspension::element
