// Shift by the law of Arrhenius.
#include "rubber_suspension/element/arrhenius_shift.h"

#include <cmath>

namespace rubber_suspension::element {

Shift ArrheniusShift::at(double temperature) const {
  // 1/T - 1/T_0 without the difference of two that are nearly equal; 0 at T_0.
  const double reference = parameters_.reference + kZeroCelsius;
  const double absolute = temperature + kZeroCelsius;
  const double difference = (parameters_.reference - temperature) / (absolute * reference);
  return {std::exp(parameters_.activation_energy / kGasConstant * difference), vertical_.at(temperature).force};
}

Range ArrheniusShift::temperatures() const {
  Range range = vertical_.temperatures();
  if (parameters_.activation_energy == 0.0) {
    return range;
  }
  const double inverse = 1.0 / (parameters_.reference + kZeroCelsius) +
                         kMostDecades * std::log(10.0) * kGasConstant / parameters_.activation_energy;
  if (inverse > 0.0) {
    const double end = 1.0 / inverse - kZeroCelsius;
    Range slow;
    (parameters_.activation_energy > 0.0 ? slow.lower : slow.upper) = end;
    range = intersection(range, slow);
  }
  return range;
}

ElementType arrheniusShiftType() {
  constexpr double kMost = 1e6;  // [J/mol]; the steepest at the glass transition reach half of it
  return {"arrhenius_shift",
          "Shift of all rates with temperature by Arrhenius, ln a_T = E/R (1/T - 1/T_0); the key `temperature` of a "
          "component makes one.",
          {{"activation_energy", "J/mol", Role::shape, Range::closed(-kMost, kMost),
            "activation energy E; negative only where it takes back another shift"},
           referenceParameter(),
           verticalParameter("vertical", 0.0)},
          makes<ArrheniusShift, ArrheniusShift::Parameters>("activation_energy", "reference", "vertical")};
}

}  // namespace rubber_suspension::element
