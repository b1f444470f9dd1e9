// Dashpot whose force follows a power of the rate.
#include <cmath>

#include "element/registry.h"
#include "element/smooth_rate.h"

namespace rubber_suspension::element {
namespace {

/// Simulates F = c v_r sign(v) |v/v_r|^p, v = dz/dt, which at the rate v_r equals the force of a dashpot c. p = 2 is
/// fluid through an orifice, p < 1 a shear-thinning fluid. SmoothRateDashpot gives the rate at a sample. The noise of
/// this rate is about 2.5/dt times the noise of the displacement, which for a small p causes large forces near
/// reversals. Source: power-law damper, e.g. Constantinou and Symans, NCEER-92-0032 (1992), section 5.
class PowerDashpot final : public SmoothRateDashpot {
 public:
  PowerDashpot(double damping /* c [N s/m] */, double reference_rate /* v_r [m/s] */, double exponent /* p [-] */)
      : damping_(damping), reference_rate_(reference_rate), exponent_(exponent) {}

  double step(const Motion& motion, double* memory) const override { return force(rateAfter(motion, memory)); }

  double force(double rate) const {
    return std::copysign(damping_ * reference_rate_ * std::pow(std::abs(rate) / reference_rate_, exponent_), rate);
  }

 private:
  double damping_;
  double reference_rate_;
  double exponent_;
};

const ElementEntry kPowerDashpotEntry(
    80, {"power_dashpot",
         "Dashpot whose force follows a power of the rate, F = c v_r sign(v) |v/v_r|^p, v = dz/dt.",
         {{"damping", "N s/m", Role::scale, Range::positive(), "damping constant c at the rate v_r"},
          {"reference_rate", "m/s", Role::reference, Range::positive(), "rate v_r at which the damping is c"},
          {"exponent", "1", Role::shape, Range::openBelow(0.0, 4.0), "power p; 1: a linear dashpot"}},
         makes<PowerDashpot>("damping", "reference_rate", "exponent")});

}  // namespace
}  // namespace rubber_suspension::element
