// Derivatives by the zero of the displacement.
#include "fit/displacement_zero.h"

#include "gap/simulate.h"

namespace rubber_suspension::fit {

std::vector<Eigen::VectorXd> byZero(const std::vector<element::ElementDescription>& elements,
                                    const std::vector<log::Record>& records,
                                    const std::vector<DisplacementZero>& zeros) {
  constexpr double kStep = 0.1;  // of a standard deviation
  std::vector<Eigen::VectorXd> columns = gap::simulate(elements, records);
  std::size_t next = 0;  // records come one after the other
  const auto moved = gap::simulate(elements, records, [&](const log::Record& record) -> Eigen::VectorXd {
    return record.displacement.array() - kStep * zeros[next++].deviation;
  });
  for (std::size_t r = 0; r < records.size(); ++r) {
    columns[r] = (moved[r] - columns[r]) / (kStep * zeros[r].one_deviation);
    columns[r].array() -= columns[r].mean();
  }
  return columns;
}

}  // namespace rubber_suspension::fit
