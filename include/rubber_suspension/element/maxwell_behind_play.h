// Spring and dashpot in series behind a play: a damper with backlash. Throws nothing.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// F = k d(z - w), dw/dt = F/c, c = k/(2 pi f_b), with the dead zone d(x) = x - clamp(x, -g, g): a Maxwell element that
/// is driven only once the clearance g to either side of its dashpot is used up. After each reversal the damper gives
/// no force for 2 g of travel; at amplitudes below g it gives none once it has settled. For g = 0 it is a Maxwell
/// element, and for a high break frequency a dashpot with backlash. The force is linear in k, the others given.
///
/// Exact for a displacement that is linear over the step: contact, free flight and contact again have closed solutions.
/// Dissipates. Validity: contact without impact or friction of the joint. Memory: where the dashpot stands.
/// Source: dead zone in series with a linear dynamic, e.g. M. Nordin, P.-O. Gutman, Automatica 38 (2002) 1633-1649.
class MaxwellBehindPlay final : public ParallelElement {
 public:
  MaxwellBehindPlay(double stiffness /* k [N/m] */, double break_frequency /* f_b [Hz] */,
                    double gap /* g, to either side [m] */);

  std::size_t memorySize() const override { return 1; }
  double initialise(double displacement, double* memory) const override;
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::viscous; }

 private:
  /// Depth of contact [m] after `time` [s], the displacement moving into contact at `velocity` [m/s].
  double depthAfter(double depth, double velocity, double time) const;
  /// Offset between displacement and dashpot [m] after `time` of constant velocity.
  double offsetAfter(double offset, double velocity, double time) const;

  double stiffness_;
  double relaxation_time_;  // tau [s]
  double gap_;
};

ElementType maxwellBehindPlayType();

}  // namespace rubber_suspension::element
