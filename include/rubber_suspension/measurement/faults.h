// Samples that a sensor did not measure: spikes, values held during a dropout, saturation. Throws nothing.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::measurement {

/// True for each sample that counts.
using Mask = Eigen::Array<bool, Eigen::Dynamic, 1>;

/// The samples of a record that count.
Mask maskOf(const log::Record& record);

/// The faults of single samples of a log.
struct Faults {
  Mask displacement;                 ///< false where the displacement was not measured
  Mask force;                        ///< false where the force was not measured
  std::vector<RigFinding> findings;  ///< spikes, held_values, saturation

  /// Samples that a fit may use.
  Mask usable() const { return displacement && force; }
};

/// Searches both channels, sampled evenly or nearly so. All limits are relative to the channel's own scatter about a
/// prediction from its neighbours, to its range, or to the other channel:
/// - a spike stands out of both neighbourhoods for one or two samples, in one channel only; the speed does not jump
///   there, so that it is no peak of a mass, and the force has no such corner where the same motion recurs, as at a
///   bump stop (after Hampel's identifier, Davies and Gather, JASA 88, 1993);
/// - a held value repeats bit by bit while the other channel moves on, and ends in a jump that the other does not have;
/// - a saturated channel piles up at its extreme value while the other one goes further out and returns, or as a force
///   that leaves this value where the displacement does not turn, which friction at its limit does.
Faults findFaults(const std::string& name, const Eigen::VectorXd& displacement, const Eigen::VectorXd& force);

/// Finds the faults of a log as read, before makeRecord(), by samples of the log.
Faults findFaults(const log::Log& log);

/// The log with both channels bridged by straight lines where they were not measured: makeRecord() of it neither
/// smooths a spike into its surroundings nor counts one as noise.
log::Log repaired(const log::Log& log, const Faults& faults);

/// The mask of a log for the record that was made of it, whose samples differ where its time base was uneven: false
/// where one of the two samples about it does not count.
Mask resampled(const Mask& mask, const log::Log& log, const log::Record& record);

/// Weights of Huber's estimator for residuals in units of their standard deviation: 1 up to 1.345, for 95 % efficiency
/// under normal noise, falling from there (Huber, Ann. Math. Stat. 35, 1964).
Eigen::VectorXd huberWeights(const Eigen::VectorXd& normalised);

/// Standard deviation by the median magnitude of the samples that count.
double robustDeviation(const Eigen::VectorXd& values, const Mask& mask);

}  // namespace rubber_suspension::measurement
