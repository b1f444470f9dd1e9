// How loud the noise of one rig may be, by all of its logs together.
#pragma once

#include <vector>

#include "rubber_suspension/log/record.h"

namespace rubber_suspension::diagnosis::prepare {

/// All logs come from one rig. What a model lacks in some of them must not pass for noise there, so a log's noise is
/// limited by that of the others: in newtons, or as a share of its force, whichever allows more.
struct NoiseLimit {
  double force = 0.0;  ///< standard deviation [N]
  double share = 0.0;  ///< of the standard deviation of the force

  /// As a gap, for one log.
  double of(const log::Record& record) const;
};

/// 1.5 times the median of the logs' noise, given as gaps: noise of 1/f differs by that much from log to log.
NoiseLimit noiseLimit(const std::vector<double>& noise, const std::vector<log::Record>& records);

/// The error of the rig in a record beside a residual of it [N], as a gap: that of an error as large as its values, in
/// standard deviations, count as, up to what 95 % of such rigs do: beyond that it is the model that errs. Any model
/// leaves it.
double rigCost(const log::Record& record, const Eigen::VectorXd& residual);

/// Let logs whose force is little more than noise, as of a hold, count less (Record::weight): one with more noise than
/// an engineer accepts of a model, and than the quietest log, counts as if it had so much. In the mean square over all
/// logs it would hide what the others show, and be the larger part of what is left. `noise`: of each log, as a gap.
void weighByNoise(const std::vector<double>& noise, std::vector<log::Record>& records);

}  // namespace rubber_suspension::diagnosis::prepare
