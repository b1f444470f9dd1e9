// Code that all temperature shifts share.
#include "rubber_suspension/element/temperature_shift.h"

namespace rubber_suspension::element {

Range intersection(const Range& a, const Range& b) {
  const Range& low = a.lower > b.lower ? a : b;
  const Range& high = a.upper < b.upper ? a : b;
  return {low.lower, high.upper, low.open_lower, high.open_upper};
}

ParameterInfo verticalParameter(const std::string& name, const std::optional<double>& default_value) {
  return {name,
          "1/K",
          Role::shape,
          Range::closed(-1.0, 1.0),
          "coefficient beta of the force, b_T = 1 + beta (T - T_0)",
          default_value};
}

ParameterInfo referenceParameter() {
  return {"reference", "degC", Role::choice, Range::openBelow(-kZeroCelsius, 1000.0),
          "temperature T_0 to which all other values of the component refer"};
}

}  // namespace rubber_suspension::element
