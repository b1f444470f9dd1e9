// Shift of the force towards the glass transition.
#include <algorithm>
#include <cmath>

#include "element/registry.h"
#include "element/shift_parts.h"

namespace rubber_suspension::element {
namespace {

/// Shifts by b_T = 1 + a (exp(-(T - T_0)/w) - 1), a_T = 1. On cooling the stiffness rises ever more steeply, as rubber
/// does towards its glass transition. Far above T_0 the factor b_T tends to 1 - a.
///
/// Validity: temperatures at which b_T is positive and the exponential is below 1e20. Source: the foot of the
/// transition in isochronous moduli, J. D. Ferry, Viscoelastic Properties of Polymers, 3rd ed., Wiley 1980, ch. 11.
class TransitionShift final : public TemperatureShift {
 public:
  TransitionShift(double share /* a [-] */, double width /* w [K] */, double reference /* T_0 [degC] */)
      : share_(share), width_(width), reference_(reference) {}

  Shift at(double temperature) const override {
    return {1.0, 1.0 + share_ * std::expm1((reference_ - temperature) / width_)};
  }

  Range temperatures() const override {
    Range range{std::max(-kZeroCelsius, reference_ - kMostDecades * std::log(10.0) * width_), Range::any().upper, true,
                false};
    if (share_ > 1.0) {
      range.upper = reference_ - width_ * std::log1p(-1.0 / share_);
      range.open_upper = true;
    }
    return range;
  }

 private:
  double share_;
  double width_;
  double reference_;
};

const ElementEntry kTransitionShiftEntry(
    380, {"transition_shift",
          "Increase of the force towards the glass transition, b_T = 1 + a (exp(-(T - T_0)/w) - 1).",
          {{"share", "1", Role::shape, Range::closed(0.0, 100.0),
            "share a of the force at T_0 that decreases with temperature"},
           {"width", "K", Role::shape, Range::closed(0.1, 1000.0),
            "temperature difference w over which this share falls by a factor of e"},
           referenceParameter()},
          makes<TransitionShift>("share", "width", "reference")});

}  // namespace
}  // namespace rubber_suspension::element
