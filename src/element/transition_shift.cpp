// Shift of the force towards the glass transition.
#include "rubber_suspension/element/transition_shift.h"

#include <algorithm>
#include <cmath>

namespace rubber_suspension::element {

Shift TransitionShift::at(double temperature) const {
  return {1.0, 1.0 + share_ * std::expm1((reference_ - temperature) / width_)};
}

Range TransitionShift::temperatures() const {
  Range range{std::max(-kZeroCelsius, reference_ - kMostDecades * std::log(10.0) * width_), Range::any().upper, true,
              false};
  if (share_ > 1.0) {
    range.upper = reference_ - width_ * std::log1p(-1.0 / share_);
    range.open_upper = true;
  }
  return range;
}

ElementType transitionShiftType() {
  return {"transition_shift",
          "Shift of the force towards the glass transition, b_T = 1 + a (exp(-(T - T_0)/w) - 1).",
          {{"share", "1", Role::shape, Range::closed(0.0, 100.0),
            "share a of the force at T_0 that falls with the temperature"},
           {"width", "K", Role::shape, Range::closed(0.1, 1000.0), "width w over which it falls by e"},
           referenceParameter()},
          makes<TransitionShift>("share", "width", "reference")};
}

}  // namespace rubber_suspension::element
