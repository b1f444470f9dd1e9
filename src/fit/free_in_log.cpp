// Columns of what is free in each log.
#include "fit/free_in_log.h"

#include <cmath>

#include "numerics/least_squares.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::fit {

Eigen::MatrixXd FreeInLog::columns(const log::Record& record, std::size_t place,
                                   const Eigen::VectorXd& simulated) const {
  Eigen::MatrixXd columns(record.size(), count());
  if (trend) {
    const Eigen::ArrayXd time = Eigen::ArrayXd::LinSpaced(record.size(), 0.0, 1.0);
    columns.col(0).setOnes();
    columns.col(1) = time - 0.5;
    for (Eigen::Index k = 2; k < kTrendsPerLog; ++k) {
      columns.col(k) = (time * element::kPi * static_cast<double>(k - 1)).cos();
    }
    columns.leftCols(kTrendsPerLog) *= record.force_deviation;
  }
  if (by_zero) {
    columns.col(trend ? kTrendsPerLog : 0) = (*by_zero)[place];
  }
  if (gain) {
    columns.rightCols<1>() = simulated;
  }
  return columns;
}

Eigen::VectorXd FreeInLog::costs(const log::Record& record) const {
  constexpr double kWalk = 0.1;  // standard deviation, of the force
  Eigen::VectorXd costs = Eigen::VectorXd::Zero(count());
  if (trend) {
    costs[1] = record.one_deviation / kWalk;
    costs.segment(2, kTrendsPerLog - 2) =
        costs[1] * Eigen::VectorXd::LinSpaced(kTrendsPerLog - 2, 1.0, static_cast<double>(kTrendsPerLog - 2));
  }
  if (by_zero) {
    costs[trend ? kTrendsPerLog : 0] = 1.0;
  }
  return costs;
}

log::Record FreeInLog::addedTo(const log::Record& record, std::size_t place, const Eigen::VectorXd& simulated) const {
  constexpr double kWide = 1e3;  // times the force: what has no prior
  log::Record result = record;
  const Eigen::MatrixXd known = numerics::columnsOfWhitening(record.nuisances);
  Eigen::MatrixXd all(record.size(), known.cols() + count());
  all.leftCols(known.cols()) = known;
  auto own = all.rightCols(count());
  own = columns(record, place, simulated) / (record.force_deviation * std::sqrt(record.counted())) *
        costs(record).cwiseMax(1.0 / kWide).cwiseInverse().asDiagonal();
  if (record.counts.size() > 0) {
    own.array().colwise() *= record.counts.array();
  }
  result.nuisances = numerics::whiteningColumns(all);
  return result;
}

gap::Forces byZero(const std::vector<element::ElementDescription>& elements, const std::vector<log::Record>& records,
                   const std::vector<DisplacementZero>& zeros) {
  constexpr double kStep = 0.1;  // of a standard deviation
  gap::Forces columns = gap::simulate(elements, records);
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
