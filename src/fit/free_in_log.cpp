// Columns of what is free in each log.
#include "fit/free_in_log.h"

#include <cmath>

#include "gap/simulate.h"
#include "numerics/least_squares.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::fit {
namespace {

// Over the samples of a log from `first` on, as many as the columns have rows, times `weight`.
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

}  // namespace

Eigen::VectorXd costsOfTrends(const log::Record& record) {
  constexpr double kWalk = 0.1;  // standard deviation, of the force
  Eigen::VectorXd orders(kTrendsPerLog);
  orders << 0.0, 1.0, Eigen::VectorXd::LinSpaced(kTrendsPerLog - 2, 1.0, static_cast<double>(kTrendsPerLog - 2));
  return record.one_deviation / kWalk * orders;
}

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
