// Columns of what is free in each log.
#include "fit/free_in_log.h"

#include "numerics/least_squares.h"

namespace rubber_suspension::fit {

void fillFreeInLog(FreeInLog free, const log::Record& record, const Eigen::VectorXd& simulated, Eigen::Index first,
                   double weight, Eigen::Ref<Eigen::MatrixXd> columns) {
  if (free.trend) {
    fillTrends(record, first, weight * record.force_deviation, columns.leftCols(kTrendsPerLog));
  }
  if (free.gain) {
    columns.rightCols<1>() = weight * simulated.segment(first, columns.rows());
  }
}

log::Record withFreeInLog(FreeInLog free, const log::Record& record, const Eigen::VectorXd& simulated) {
  log::Record result = record;
  const Eigen::Index known = record.nuisances.cols();
  Eigen::MatrixXd columns(record.size(), known + free.count());
  columns.leftCols(known) = record.nuisances;
  fillFreeInLog(free, record, simulated, 0, 1.0 / record.force_deviation, columns.rightCols(free.count()));
  if (record.counts.size() > 0) {
    columns.rightCols(free.count()).array().colwise() *= record.counts.array();
  }
  // The zero may be among the nuisances already.
  result.nuisances = numerics::orthonormalColumns(columns);
  return result;
}

}  // namespace rubber_suspension::fit
