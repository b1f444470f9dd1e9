// Dashpot that thins under shear.
#include <cmath>

#include "element/registry.h"
#include "element/smooth_rate.h"

namespace rubber_suspension::element {
namespace {

/// Simulates F = c v/(1 + |v|/v_h), v = dz/dt, which is a linear dashpot for slow motion. At the rate v_h its damping
/// is halved; its force remains below c v_h. SmoothRateDashpot gives the rate at a sample. Source: M. M. Cross, J.
/// Colloid Sci. 20 (1965) 417-437, Eq. 6, with the exponent 1 and no damping at infinite rate.
class ThinningDashpot final : public SmoothRateDashpot {
 public:
  ThinningDashpot(double damping /* c [N s/m] */, double half_rate /* v_h [m/s] */)
      : damping_(damping), half_rate_(half_rate) {}

  double step(const Motion& motion, double* memory) const override { return force(rateAfter(motion, memory)); }

  double force(double rate) const { return damping_ * rate / (1.0 + std::abs(rate) / half_rate_); }

 private:
  double damping_;
  double half_rate_;
};

const ElementEntry kThinningDashpotEntry(
    90, {"thinning_dashpot",
         "Dashpot with shear thinning, F = c v/(1 + |v|/v_h), v = dz/dt; the force is at most c v_h.",
         {{"damping", "N s/m", Role::scale, Range::positive(), "damping constant c at slow motion"},
          {"half_rate", "m/s", Role::shape, Range::positive(), "rate v_h at which the damping is c/2"}},
         makes<ThinningDashpot>("damping", "half_rate")});

}  // namespace
}  // namespace rubber_suspension::element
