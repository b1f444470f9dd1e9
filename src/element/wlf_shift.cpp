// Shift by the equation of Williams, Landel and Ferry.
#include "rubber_suspension/element/wlf_shift.h"

#include <cmath>

namespace rubber_suspension::element {

Shift WlfShift::at(double temperature) const {
  const double above = temperature - parameters_.reference;
  return {std::pow(10.0, -parameters_.c1 * above / (parameters_.c2 + above)), vertical_.at(temperature).force};
}

Range WlfShift::temperatures() const {
  // -C_1 x/(C_2 + x) = kMostDecades, x = T - T_0.
  const double lowest = parameters_.reference - parameters_.c2 * kMostDecades / (kMostDecades + parameters_.c1);
  Range range;
  range.lower = lowest;
  return intersection(vertical_.temperatures(), range);
}

ElementType wlfShiftType() {
  return {"wlf_shift",
          "Shift of all rates with temperature by Williams, Landel and Ferry, log10 a_T = -C_1 (T - T_0)/(C_2 + T - "
          "T_0); the key `temperature` of a component makes one.",
          {{"c1", "1", Role::shape, Range::openBelow(0.0, 100.0), "constant C_1 at the reference temperature"},
           {"c2", "K", Role::shape, Range::openBelow(0.0, 1000.0),
            "constant C_2 at the reference temperature, a difference of temperatures"},
           referenceParameter(),
           verticalParameter("vertical", 0.0)},
          makes<WlfShift, WlfShift::Parameters>("c1", "c2", "reference", "vertical")};
}

}  // namespace rubber_suspension::element
