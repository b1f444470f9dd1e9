// What is free in each log alone, as no model run reproduces it.
#pragma once

#include <Eigen/Core>

#include "fit/trends.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

/// Which of them belong to a hypothesis.
struct FreeInLog {
  bool trend = false;  ///< a slow trend
  bool gain = false;   ///< a gain of the force's channel

  bool any() const { return trend || gain; }

  /// Unknowns of each log, the trend's first.
  Eigen::Index count() const { return (trend ? kTrendsPerLog : 0) + (gain ? 1 : 0); }

  friend FreeInLog operator|(FreeInLog one, FreeInLog other) {
    return {one.trend || other.trend, one.gain || other.gain};
  }
};

/// Their columns over the samples of a log from `first` on, as many as the columns have rows, times `weight` [1/N].
/// `simulated`: the model's force on the whole log, which a gain changes.
void fillFreeInLog(FreeInLog free, const log::Record& record, const Eigen::VectorXd& simulated, Eigen::Index first,
                   double weight, Eigen::Ref<Eigen::MatrixXd> columns);

/// The record with these among the nuisances: what the rig may have added to it (Record::withoutRig).
log::Record withFreeInLog(FreeInLog free, const log::Record& record, const Eigen::VectorXd& simulated);

}  // namespace rubber_suspension::fit
