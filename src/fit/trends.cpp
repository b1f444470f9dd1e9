// Columns of slow trends.
#include "fit/trends.h"

#include <Eigen/QR>

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

log::Record withFreeTrend(const log::Record& record) {
  log::Record result = record;
  const Eigen::Index known = record.nuisances.cols();
  Eigen::MatrixXd columns(record.size(), known + kTrendsPerLog);
  columns.leftCols(known) = record.nuisances;
  fillTrends(record, 0, 1.0, columns.rightCols(kTrendsPerLog));
  if (record.counts.size() > 0) {
    columns.rightCols(kTrendsPerLog).array().colwise() *= record.counts.array();
  }
  // The zero may be among the nuisances already.
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  result.nuisances = qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), qr.rank());
  return result;
}

}  // namespace rubber_suspension::fit
