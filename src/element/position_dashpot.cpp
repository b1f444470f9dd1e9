// Dashpot whose damping grows with the displacement to one side.
#include <algorithm>
#include <cmath>

#include "element/registry.h"
#include "element/smooth_rate.h"

namespace rubber_suspension::element {
namespace {

/// Simulates F = c s^p v, s = max(0, (1 + side z/z_r)/2), v = dz/dt. The damping is 0 at z_r on the other side, c at
/// z_r on the given side, and larger beyond; the larger the power p, the later the damping rises. Two such elements,
/// one for each side, and a linear dashpot in parallel describe a closing gap, as in a squeeze film or a hydraulic
/// stop. They dissipate if no damping is negative. SmoothRateDashpot gives the rate at a sample. Source: the damping of
/// a squeeze film grows with the inverse cube of its thickness (O. Reynolds, Phil. Trans. R. Soc. 177, 1886); powers of
/// the position replace it here, since they have no singularity.
class PositionDashpot final : public SmoothRateDashpot {
 public:
  PositionDashpot(double damping /* c [N s/m] */,
                  double reference_displacement /* z_r, with the sign of its side [m] */, double power /* p [-] */)
      : damping_(damping), reference_(reference_displacement), power_(power) {}

  double step(const Motion& motion, double* memory) const override {
    return dampingAt(motion.displacement) * rateAfter(motion, memory);
  }

  double dampingAt(double displacement) const {
    return damping_ * std::pow(std::max(0.0, 0.5 * (1.0 + displacement / reference_)), power_);
  }

 private:
  double damping_;
  double reference_;
  double power_;
};

const ElementEntry kPositionDashpotEntry(
    100,
    {"position_dashpot",
     "Dashpot whose damping grows towards one side (closing gap), F = c s^p dz/dt, s = max((1 + side z/z_r)/2, 0).",
     {{"damping", "N s/m", Role::scale, Range::positive(),
       "damping constant c at the distance z_r on the side of growth"},
      {"reference_displacement", "m", Role::shape, Range::positive(),
       "distance z_r from 0: the damping is c at z_r on the side of growth, and 0 at z_r on the other side"},
      {"power", "1", Role::shape, Range::closed(0.1, 20.0), "exponent p; the larger, the later the damping grows"},
      {"side", "1", Role::choice, Range::closed(-1.0, 1.0), "1: the damping grows towards z > 0, -1: towards z < 0",
       1.0}},
     [](const ElementDescription& description) -> ElementPointer {
       const double towards = sideOf(description, "z", false) * description.value("reference_displacement");
       return std::make_shared<const PositionDashpot>(description.value("damping"), towards,
                                                      description.value("power"));
     }});

}  // namespace
}  // namespace rubber_suspension::element
