// Limits of the noise of one rig, from all of its logs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::measurement {

/// Accepted errors of a model: numbers of the judgement (judge/numbers.h), passed as values.
struct ErrorScale {
  double accepted = 0.0;     ///< error that is accepted, in units of the force's standard deviation
  double floor_known = 0.0;  ///< relative error by which a noise floor may be too low
  double sharpness = 0.0;    ///< number of independent errors that all logs together count as

  /// Returns the error in one of `logs` logs, in units of the force's standard deviation, that is as improbable to the
  /// judgement as one standard deviation of any error of the rig.
  double oneDeviation(double floor, std::size_t logs) const;

  /// Returns such an error over all logs, independent of their noise, for one standard deviation of the data sheet.
  double oneOfSheet() const { return oneDeviation(0.0, 1); }
};

/// Limit of a log's noise by that of the others of its rig, so that an error of the model in some logs does not pass
/// for noise there: in newtons, or as a share of its force, whichever allows more.
struct NoiseLimit {
  double force = 0.0;  ///< standard deviation [N]
  double share = 0.0;  ///< of the standard deviation of the force

  /// Returns the limit of one log, as a gap.
  double of(const log::Record& record) const;
};

/// Returns 1.5 times the median of the logs' noise, given as gaps: 1/f noise differs by that much from log to log.
NoiseLimit noiseLimit(const std::vector<double>& noise, const std::vector<gap::PreparedRecord>& records);

/// Returns the part of a residual [N] that errors of the rig explain, as a gap, by how improbable the rig's values are.
/// It is limited to the 95 % quantile, beyond which the model is wrong. The residual of any model has this part.
double rigCost(const gap::PreparedRecord& record, const Eigen::VectorXd& residual);

/// Weight of a log among others of its rig.
struct LogWeight {
  double weight = 1.0;  ///< about 1 on average (gap::PreparedRecord::weight)
  std::string note;     ///< empty if its weight is not reduced
};

/// Returns lower weights for logs whose force is little more than noise, such as holds: one with more noise than the
/// accepted error of a model, and than the quietest log, counts as if it had only that much. Otherwise it would
/// dominate the mean square over all logs and hide what the others show. `noise`: of each log, as a gap.
std::vector<LogWeight> weightsByNoise(const std::vector<double>& noise, double accepted);

}  // namespace rubber_suspension::measurement
