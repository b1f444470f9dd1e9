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
  double floor_known = 0.0;  ///< share of itself that a floor may be too low by
  double sharpness = 0.0;    ///< independent errors that all logs together are worth

  /// Error in one of `logs` logs that one standard deviation of anything that the rig does counts as, in units of the
  /// force's standard deviation: the judgement takes it for as improbable as any number at its deviation.
  double oneDeviation(double floor, std::size_t logs) const;

  /// Error of a deviation from the data sheet by one standard deviation, over all logs, independent of their noise.
  double oneOfSheet() const { return oneDeviation(0.0, 1); }
};

/// All logs come from one rig. What a model lacks in some of them must not pass for noise there, so a log's noise is
/// limited by that of the others: in newtons, or as a share of its force, whichever allows more.
struct NoiseLimit {
  double force = 0.0;  ///< standard deviation [N]
  double share = 0.0;  ///< of the standard deviation of the force

  /// As a gap, for one log.
  double of(const log::Record& record) const;
};

/// 1.5 times the median of the logs' noise, given as gaps: noise of 1/f differs by that much from log to log.
NoiseLimit noiseLimit(const std::vector<double>& noise, const std::vector<gap::PreparedRecord>& records);

/// The error of the rig in a record beside a residual of it [N], as a gap: that of an error as large as its values, in
/// standard deviations, count as, up to what 95 % of such rigs do: beyond that it is the model that errs. Any model
/// leaves it.
double rigCost(const gap::PreparedRecord& record, const Eigen::VectorXd& residual);

/// Weight of a log among others of its rig.
struct LogWeight {
  double weight = 1.0;  ///< about 1 on average (gap::PreparedRecord::weight)
  std::string note;     ///< empty where it counts no less than another
};

/// Logs whose force is little more than noise, as of a hold, count less: one with more noise than
/// the error that is accepted of a model, and than the quietest log, counts as if it had so much. In the mean square
/// over all logs it would hide what the others show, and be the larger part of what is left. `noise`: of each log, as a
/// gap.
std::vector<LogWeight> weightsByNoise(const std::vector<double>& noise, double accepted);

}  // namespace rubber_suspension::measurement
