// Columns of what is free in each log.
#include "fit/free_in_log.h"

#include <cmath>

#include "numerics/least_squares.h"

namespace rubber_suspension::fit {

void fillFreeInLog(FreeInLog free, const log::Record& record, const Eigen::VectorXd& simulated,
                   const Eigen::VectorXd& by_zero, Eigen::Index first, double weight,
                   Eigen::Ref<Eigen::MatrixXd> columns) {
  if (free.trend) {
    fillTrends(record, first, weight * record.force_deviation, columns.leftCols(kTrendsPerLog));
  }
  if (free.zero) {
    columns.col(free.trend ? kTrendsPerLog : 0) = weight * by_zero.segment(first, columns.rows());
  }
  if (free.gain) {
    columns.rightCols<1>() = weight * simulated.segment(first, columns.rows());
  }
}

log::Record withFreeInLog(FreeInLog free, const log::Record& record, const Eigen::VectorXd& simulated,
                          const Eigen::VectorXd& by_zero) {
  constexpr double kWide = 1e3;  // times the force: what has no prior
  log::Record result = record;
  const Eigen::MatrixXd known = numerics::columnsOfWhitening(record.nuisances);
  Eigen::MatrixXd columns(record.size(), known.cols() + free.count());
  columns.leftCols(known.cols()) = known;
  auto own = columns.rightCols(free.count());
  fillFreeInLog(free, record, simulated, by_zero, 0, 1.0 / (record.force_deviation * std::sqrt(record.counted())), own);
  if (record.counts.size() > 0) {
    own.array().colwise() *= record.counts.array();
  }
  if (free.trend) {
    own.leftCols(kTrendsPerLog) *= costsOfTrends(record).cwiseMax(1.0 / kWide).cwiseInverse().asDiagonal();
  }
  own.rightCols(free.gain ? 1 : 0) *= kWide;
  result.nuisances = numerics::whiteningColumns(columns);
  return result;
}

}  // namespace rubber_suspension::fit
