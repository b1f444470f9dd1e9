// Friction behind a play: a branch that is driven only once its clearance is used up. Throws nothing.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// A Jenkins slider behind a clearance of its own: no force while the displacement is within +-g of the slider, a
/// spring k beyond, and at k y the slider is pulled along. Other than free play before the whole test piece, only this
/// branch is slack, and the clearance moves along with the slider: after each reversal the friction is missing for 2 g
/// of travel, whatever the amplitude. Settled loss per cycle at amplitude A > g + y: 4 k y (A - g - y).
///
/// Rate-independent, exact for any step, dissipates. Validity: contact without impact. The force is linear in k.
/// Memory: where the slider stands. Source: elastic-plastic element with a gap, e.g. K. Worden, G. R. Tomlinson,
/// Nonlinearity in Structural Dynamics (2001).
class FrictionBehindPlay final : public ParallelElement {
 public:
  FrictionBehindPlay(double stiffness /* k [N/m] */, double yield_displacement /* y [m] */,
                     double gap /* g, to either side [m] */)
      : stiffness_(stiffness), yield_displacement_(yield_displacement), gap_(gap) {}

  std::size_t memorySize() const override { return 1; }
  double initialise(double displacement, double* memory) const override;
  double step(const Motion& motion, double* memory) const override;
  Part part() const override { return Part::friction; }

 private:
  double stiffness_;
  double yield_displacement_;
  double gap_;
};

ElementType frictionBehindPlayType();

}  // namespace rubber_suspension::element
