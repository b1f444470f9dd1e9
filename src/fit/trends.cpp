// Columns of slow trends.
#include "fit/trends.h"

#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::fit {

void fillTrends(const log::Record& record, Eigen::Index first, double weight, Eigen::Ref<Eigen::MatrixXd> columns) {
  const Eigen::ArrayXd time = Eigen::ArrayXd::LinSpaced(columns.rows(), static_cast<double>(first),
                                                        static_cast<double>(first + columns.rows() - 1)) /
                              static_cast<double>(record.size() - 1);
  columns.col(0).setConstant(weight);
  columns.col(1) = weight * (time - 0.5);
  for (Eigen::Index k = 2; k < kTrendsPerLog; ++k) {
    columns.col(k) = weight * (time * element::kPi * static_cast<double>(k - 1)).cos();
  }
}

Eigen::VectorXd costsOfTrends(const log::Record& record) {
  constexpr double kWalk = 0.1;  // standard deviation, of the force
  Eigen::VectorXd orders(kTrendsPerLog);
  orders << 0.0, 1.0, Eigen::VectorXd::LinSpaced(kTrendsPerLog - 2, 1.0, static_cast<double>(kTrendsPerLog - 2));
  return record.one_deviation / kWalk * orders;
}

}  // namespace rubber_suspension::fit
