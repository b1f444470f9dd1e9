// Dashpot whose damping grows towards one side. Its make() throws std::invalid_argument for a side other than 1 or -1.
#pragma once

#include "rubber_suspension/element/smooth_rate.h"

namespace rubber_suspension::element {

/// F = c s^p v, s = max(0, (1 + side z/z_r)/2), v = dz/dt: the damping is c at z_r on that side, 0 at the same distance
/// on the other, and continues to grow beyond; the larger the power p, the later. Sums of both sides and of a linear
/// dashpot compose what a closing gap does, as in a squeeze film or a hydraulic stop, and dissipate as long as none is
/// negative. The rate at a sample is that of SmoothRateDashpot. Source: the damping of a squeeze film grows with the
/// inverse cube of its thickness (O. Reynolds, Phil. Trans. R. Soc. 177, 1886); powers of the position here, which have
/// no singularity that a test piece could not reach.
class PositionDashpot final : public SmoothRateDashpot {
 public:
  PositionDashpot(double damping /* c [N s/m] */,
                  double reference_displacement /* z_r, with the sign of its side [m] */, double power /* p [-] */)
      : damping_(damping), reference_(reference_displacement), power_(power) {}

  double step(const Motion& motion, double* memory) const override {
    return dampingAt(motion.displacement) * rateAfter(motion, memory);
  }

  /// Damping [N s/m] at a displacement [m].
  double dampingAt(double displacement) const;

 private:
  double damping_;
  double reference_;
  double power_;
};

ElementType positionDashpotType();

}  // namespace rubber_suspension::element
