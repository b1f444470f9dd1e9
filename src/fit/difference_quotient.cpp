// Difference quotients of forces.
#include "fit/difference_quotient.h"

#include <utility>

namespace rubber_suspension::fit {

double takenStep(double step, const std::function<bool(double by)>& hasForce) {
  return hasForce(step) ? step : hasForce(-step) ? -step : 0.0;
}

ForceColumn quotient(const gap::Forces& base, double step,
                     const std::function<std::optional<gap::Forces>(double by)>& moved) {
  std::optional<gap::Forces> forces;
  const double taken = takenStep(step, [&](double by) {
    forces = moved(by);
    return forces.has_value();
  });
  gap::Forces column = std::move(forces).value_or(base);
  for (std::size_t r = 0; r < base.size(); ++r) {
    column[r] = (column[r] - base[r]) / (taken != 0.0 ? taken : step);
  }
  return columnOf(std::move(column));
}

}  // namespace rubber_suspension::fit
