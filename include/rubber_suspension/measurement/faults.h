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

/// Returns the samples of a record that count.
Mask maskOf(const log::Record& record);

/// The faults of single samples of a log.
struct Faults {
  Mask displacement;                 ///< false where the displacement was not measured
  Mask force;                        ///< false where the force was not measured
  std::vector<RigFinding> findings;  ///< spikes, held_values, saturation

  /// Returns the samples that a fit may use.
  Mask usable() const { return displacement && force; }
};

/// Searches both channels, sampled evenly or nearly so. All limits are relative to the channel's own scatter about a
/// prediction from its neighbours, to its range, or to the other channel:
/// - a spike exceeds the neighbours on both sides for one or two samples, in one channel only. It is no peak of a mass,
///   at which the speed jumps, and no corner of the force that recurs with the same motion, as at a bump stop (after
///   Hampel's identifier, Davies and Gather, JASA 88, 1993);
/// - a held value repeats bit by bit while the other channel moves, and ends in a jump that the other does not have, or
///   interrupts the noise of a force;
/// - a saturated channel has many samples at its extreme value while the other goes further out and returns; or it is a
///   force whose noise stops there, or which leaves this value while the displacement does not turn, unlike friction.
Faults findFaults(const std::string& name, const Eigen::VectorXd& displacement, const Eigen::VectorXd& force);

/// Finds the faults of a log as read, before makeRecord(); masks have one entry per sample of the log.
Faults findFaults(const log::Log& log);

/// Returns the log with straight lines where a channel was not measured, so that makeRecord() neither smooths a spike
/// into its surroundings nor counts it as noise.
log::Log repaired(const log::Log& log, const Faults& faults);

/// Converts the mask of a log to that of its record, whose samples differ if its time base was uneven: false where one
/// of the two neighbouring samples of the log does not count.
Mask resampled(const Mask& mask, const log::Log& log, const log::Record& record);

/// Returns the weights of Huber's estimator for residuals in units of their standard deviation: 1 up to 1.345, for 95 %
/// efficiency under normal noise, 1.345 over the magnitude beyond (Huber, Ann. Math. Stat. 35, 1964).
Eigen::VectorXd huberWeights(const Eigen::VectorXd& normalised);

/// Returns the standard deviation of normal noise with the median magnitude of the samples that count.
double robustDeviation(const Eigen::VectorXd& values, const Mask& mask);

}  // namespace rubber_suspension::measurement
