// Samples that a sensor did not measure: spikes, values held during a dropout, saturation. No function here throws.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::measurement {

/// True for each sample that counts, that is, that fits and statistics use.
using Mask = Eigen::Array<bool, Eigen::Dynamic, 1>;

/// Returns the samples of a record that count.
Mask maskOf(const log::Record& record);

struct Faults {
  Mask displacement;                 ///< false where the displacement was not measured
  Mask force;                        ///< false where the force was not measured
  std::vector<RigFinding> findings;  ///< spikes, held_values, saturation

  /// Returns the samples that a fit may use.
  Mask usable() const { return displacement && force; }
};

/// Searches both channels, which are sampled evenly or nearly so. All limits are relative to the scatter of the channel
/// about a prediction from its neighbours, to its range, or to the other channel:
/// - a spike exceeds the neighbours on both sides for one or two samples, in one channel only. Two kinds of peaks are
/// excluded: those of a mass where the speed jumps, and corners of the force that recur with the same motion, as at a
/// bump stop (after Hampel's identifier, Davies and Gather, JASA 88, 1993);
/// - a held value repeats bit by bit while the other channel moves. It ends in a jump that the other channel does not
/// have, or it interrupts the noise of a force;
/// - a saturated channel has many samples at its extreme value while the other channel goes further out and returns. A
/// force is also saturated if its noise stops at this value, or if it leaves this value while the displacement does not
/// turn, which friction does not do.
Faults findFaults(const std::string& name, const Eigen::VectorXd& displacement, const Eigen::VectorXd& force);

/// Finds the faults of a log as read, before makeRecord(); masks have one entry per sample of the log.
Faults findFaults(const log::Log& log);

/// Returns the log with straight lines in place of the samples that a channel did not measure, so that makeRecord()
/// neither smooths a spike into its surroundings nor treats it as noise.
log::Log repaired(const log::Log& log, const Faults& faults);

/// Converts the mask of a log to that of its record, which has other samples if the time base was uneven. A sample of
/// the record is false if one of the two neighbouring samples of the log does not count.
Mask resampled(const Mask& mask, const log::Log& log, const log::Record& record);

/// Returns the weights of Huber's estimator for residuals in units of their standard deviation: 1 for magnitudes up to
/// 1.345, beyond that 1.345 divided by the magnitude (95 % efficiency; Huber, Ann. Math. Stat. 35, 1964).
Eigen::VectorXd huberWeights(const Eigen::VectorXd& normalised);

/// Returns the standard deviation of the samples that count, from their median magnitude, as for normal noise.
double robustDeviation(const Eigen::VectorXd& values, const Mask& mask);

}  // namespace rubber_suspension::measurement
