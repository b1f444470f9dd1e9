// Limits of the noise of one rig, from all of its logs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::measurement {

/// Errors of a model that the judgement accepts (judge/numbers.h).
struct ErrorScale {
  double accepted = 0.0;     ///< accepted error, in units of the force's standard deviation
  double floor_known = 0.0;  ///< relative error by which a noise floor may be too low
  double sharpness = 0.0;    ///< number of independent errors to which all logs together amount

  /// Returns the error in one of `logs` logs, in units of the force's standard deviation, that the judgement considers
  /// as improbable as one standard deviation of an error of the rig.
  double oneDeviation(double floor, std::size_t logs) const;

  /// Returns oneDeviation() over all logs, independent of noise, for one standard deviation of the data sheet.
  double oneOfSheet() const { return oneDeviation(0.0, 1); }
};

/// Limit of the noise of a log from that of the other logs of its rig, so that an error of the model is not mistaken
/// for noise. It is a force or a share of the log's force, whichever allows more.
struct NoiseLimit {
  double force = 0.0;  ///< standard deviation [N]
  double share = 0.0;  ///< share of the standard deviation of the force

  /// Returns the limit for one log, as a gap.
  double of(const log::Record& record) const;
};

/// Returns 1.5 times the median noise of the logs (`noise`: as gaps), because 1/f noise differs by that much.
NoiseLimit noiseLimit(const std::vector<double>& noise, const std::vector<gap::PreparedRecord>& records);

/// Returns, as a gap, the part of a residual [N] that errors of the rig explain, from the improbability of their
/// values. It is limited to the 95 % quantile, beyond which the model is wrong. Any model has this part.
double rigCost(const gap::PreparedRecord& record, const Eigen::VectorXd& residual);

/// Weight of a log relative to the other logs of its rig.
struct LogWeight {
  double weight = 1.0;  ///< factor, about 1 on average (gap::PreparedRecord::weight)
  std::string note;     ///< empty if its weight is not reduced
};

/// Returns lower weights for logs whose force is little more than noise, such as holds. A log with more noise than the
/// accepted error of a model and than the quietest log counts as if it had only that much noise. Otherwise it would
/// dominate the mean square over all logs and hide what the other logs show. `noise`: noise of each log, as a gap.
std::vector<LogWeight> weightsByNoise(const std::vector<double>& noise, double accepted);

}  // namespace rubber_suspension::measurement
