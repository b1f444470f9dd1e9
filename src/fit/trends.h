// The slow trend of a log, which no model run reproduces: a drift of its own.
#pragma once

#include <Eigen/Core>

#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

constexpr Eigen::Index kTrendsPerLog = 10;  ///< the zero, a ramp and eight half cosines

/// These over the samples of a log from `first` on, as many as the columns have rows, times `weight`.
void fillTrends(const log::Record& record, Eigen::Index first, double weight, Eigen::Ref<Eigen::MatrixXd> columns);

/// The error that each of them counts as where it is as large as the force. The zero is free. Half cosines are those of
/// a random walk, which is as wide as zeros are on a bench of which nothing is known: free ones predict nothing between
/// the samples that they are fitted to.
Eigen::VectorXd costsOfTrends(const log::Record& record);

}  // namespace rubber_suspension::fit
