// One-sided and central difference quotients.
#include "numerics/difference_quotient.h"

#include <utility>

namespace rubber_suspension::numerics {

double takenStep(double step, const std::function<bool(double by)>& has_value) {
  return has_value(step) ? step : has_value(-step) ? -step : 0.0;
}

std::vector<Eigen::VectorXd> quotient(
    const std::vector<Eigen::VectorXd>& base, double step,
    const std::function<std::optional<std::vector<Eigen::VectorXd>>(double by)>& moved) {
  std::optional<std::vector<Eigen::VectorXd>> values;
  const double taken = takenStep(step, [&](double by) {
    values = moved(by);
    return values.has_value();
  });
  std::vector<Eigen::VectorXd> slopes = std::move(values).value_or(base);
  for (std::size_t r = 0; r < base.size(); ++r) {
    slopes[r] = (slopes[r] - base[r]) / (taken != 0.0 ? taken : step);
  }
  return slopes;
}

Eigen::MatrixXd centralDifferences(const std::function<Eigen::VectorXd(const Eigen::VectorXd& x)>& values,
                                   const Eigen::VectorXd& x, double step) {
  Eigen::MatrixXd slopes;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Eigen::VectorXd moved = step * Eigen::VectorXd::Unit(x.size(), i);
    const Eigen::VectorXd slope = (values(x + moved) - values(x - moved)) / (2.0 * step);
    slopes.conservativeResize(slope.size(), x.size());
    slopes.col(i) = slope;
  }
  return slopes;
}

Eigen::VectorXd slopesOf(const Eigen::Ref<const Eigen::VectorXd>& signal) {
  const Eigen::Index last = signal.size() - 1;
  Eigen::VectorXd slopes(signal.size());
  slopes.segment(1, last - 1) = (signal.tail(last - 1) - signal.head(last - 1)) / 2.0;
  slopes[0] = signal[1] - signal[0];
  slopes[last] = signal[last] - signal[last - 1];
  return slopes;
}

}  // namespace rubber_suspension::numerics
