// Shift of the force with temperature.
#include "rubber_suspension/element/vertical_shift.h"

namespace rubber_suspension::element {

Range VerticalShift::temperatures() const {
  const Range above_zero{-kZeroCelsius, Range::any().upper, true, false};
  if (coefficient_ == 0.0) {
    return above_zero;
  }
  const double end = reference_ - 1.0 / coefficient_;
  Range positive;
  if (coefficient_ > 0.0) {
    positive.lower = end;
    positive.open_lower = true;
  } else {
    positive.upper = end;
    positive.open_upper = true;
  }
  return intersection(above_zero, positive);
}

ElementType verticalShiftType() {
  return {"vertical_shift",
          "Shift of the force alone with temperature, b_T = 1 + beta (T - T_0).",
          {verticalParameter("coefficient", std::nullopt), referenceParameter()},
          makes<VerticalShift>("coefficient", "reference")};
}

}  // namespace rubber_suspension::element
