// Difference quotients of forces.
#include "fit/difference_quotient.h"

#include <utility>

namespace rubber_suspension::fit {

ForceColumn quotient(const gap::Forces& base, double step,
                     const std::function<std::optional<gap::Forces>(double by)>& moved) {
  std::optional<gap::Forces> forces = moved(step);
  if (!forces) {
    step = -step;
    forces = moved(step);
  }
  gap::Forces column = std::move(forces).value_or(base);
  for (std::size_t r = 0; r < base.size(); ++r) {
    column[r] = (column[r] - base[r]) / step;
  }
  return columnOf(std::move(column));
}

}  // namespace rubber_suspension::fit
