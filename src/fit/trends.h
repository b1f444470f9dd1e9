// The slow trend of a log, which no model run reproduces: a drift of its own.
#pragma once

#include <Eigen/Core>

#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

constexpr Eigen::Index kTrendsPerLog = 10;  ///< the zero, a ramp and eight half cosines

/// These over the samples of a log from `first` on, as many as the columns have rows, times `weight`.
void fillTrends(const log::Record& record, Eigen::Index first, double weight, Eigen::Ref<Eigen::MatrixXd> columns);

}  // namespace rubber_suspension::fit
