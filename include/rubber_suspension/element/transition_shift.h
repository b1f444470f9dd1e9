// Shift of the force towards the glass transition. Throws nothing.
#pragma once

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::element {

/// b_T = 1 + a (exp(-(T - T_0)/w) - 1), a_T = 1: the stiffness rises the faster the colder it is, as rubber does on the
/// way to its glass transition, and keeps 1 - a far above T_0.
///
/// Holds where the factor is positive, and as far as 20 decades of the exponential. Source: the foot of the transition
/// in isochronous moduli, J. D. Ferry, Viscoelastic Properties of Polymers, 3rd ed., Wiley 1980, ch. 11.
class TransitionShift final : public TemperatureShift {
 public:
  TransitionShift(double share /* a [-] */, double width /* w [K] */, double reference /* T_0 [degC] */)
      : share_(share), width_(width), reference_(reference) {}

  Shift at(double temperature) const override;
  Range temperatures() const override;

 private:
  double share_;
  double width_;
  double reference_;
};

ElementType transitionShiftType();

}  // namespace rubber_suspension::element
