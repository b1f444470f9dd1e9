// Unknowns of each log alone, which no model run reproduces.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

/// Of the slow trend of a log, a drift of its own: the zero, a ramp and eight half cosines.
constexpr Eigen::Index kTrendsPerLog = 10;

/// Which of them belong to a hypothesis.
struct FreeInLog {
  bool trend = false;  ///< a slow trend
  bool gain = false;   ///< a gain of the force's channel
  bool zero = false;   ///< a zero of the displacement, which has a prior

  bool any() const { return trend || gain || zero; }

  /// Unknowns of each log: the trend's, the zero, the gain.
  Eigen::Index count() const { return (trend ? kTrendsPerLog : 0) + (zero ? 1 : 0) + (gain ? 1 : 0); }

  friend FreeInLog operator|(FreeInLog one, FreeInLog other) {
    return {one.trend || other.trend, one.gain || other.gain, one.zero || other.zero};
  }
};

/// Their columns over the samples of a log from `first` on, as many as the columns have rows, times `weight` [1/N].
/// `simulated`: the model's force on the whole log, which a gain changes. `by_zero`: what a zero of the displacement
/// does to it (Hypothesis::by_zero), where that is free.
void fillFreeInLog(FreeInLog free, const log::Record& record, const Eigen::VectorXd& simulated,
                   const Eigen::VectorXd& by_zero, Eigen::Index first, double weight,
                   Eigen::Ref<Eigen::MatrixXd> columns);

/// The error that each column of a trend counts as where it is as large as the force. The zero is free. Half cosines
/// are those of a random walk, which is as wide as zeros are on a bench of which nothing is known: free ones predict
/// nothing between the samples that they are fitted to.
Eigen::VectorXd costsOfTrends(const log::Record& record);

/// The knowledge before any fit of a displacement that was recorded too high by the same amount throughout a log.
struct DisplacementZero {
  double deviation = 0.0;      ///< standard deviation [m]; 0: there is none
  double one_deviation = 0.0;  ///< what that counts as, in units of the standard deviation of the force
};

/// The effect of one standard deviation of the zero on the force of elements on each record [N], its mean taken out,
/// which is a zero of the force; over what it counts as.
std::vector<Eigen::VectorXd> byZero(const std::vector<element::ElementDescription>& elements,
                                    const std::vector<log::Record>& records,
                                    const std::vector<DisplacementZero>& zeros);

/// The record with these among the nuisances: what the rig may have added to it (Record::withoutRig).
log::Record withFreeInLog(FreeInLog free, const log::Record& record, const Eigen::VectorXd& simulated,
                          const Eigen::VectorXd& by_zero = {});

}  // namespace rubber_suspension::fit
