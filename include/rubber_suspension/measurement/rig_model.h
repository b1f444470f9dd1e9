// Errors of a rig in the force of each log: offsets, delay, clock, gain and a start in motion; estimated and removed by
// generalised least squares.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/io/rig_tolerances.h"
#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/faults.h"
#include "rubber_suspension/measurement/noise_model.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::measurement {

/// Meaning of a column; its value is in the unit in brackets.
enum class Nuisance {
  force_zero,         ///< offset of the recorded force [N]
  displacement_zero,  ///< offset of the recorded displacement [m]
  delay,              ///< of the recorded force behind the displacement, in the middle of the log [s]
  clock,              ///< growth of that delay per time [-]
  gain,               ///< relative error of the recorded force, positive if too large [-]
  initial_state,  ///< force from a motion before the log [N]: the first value of one that decays with one relaxation
                  ///< time, or the prior's standard deviation times a share of the force after a typical motion
};

/// Linearisation point of a log: the displacement offset and the delays removed before.
struct RigPoint {
  double displacement_zero = 0.0;  ///< [m]
  double delay = 0.0;              ///< [s]
  double clock = 0.0;              ///< [-]
};

/// The force that the rig may add to one log, linear in its values: recorded = base + columns * values.
struct RigColumns {
  Eigen::VectorXd base;             ///< simulated force; with a point, that of the point minus columns * point [N]
  std::vector<Nuisance> nuisances;  ///< of each column; initial_state has several, others one at most
  Eigen::MatrixXd columns;          ///< samples x nuisances [N per unit of the value]
  Eigen::VectorXd priors;           ///< standard deviation of each value
};

/// Fit of the errors of the rig in one log.
struct RigFit {
  RigColumns rig;
  Eigen::VectorXd values;
  Eigen::MatrixXd covariance;   ///< of the values, prior included
  Eigen::VectorXd correction;   ///< force that the rig adds to the simulated one [N]
  Eigen::VectorXd residual;     ///< measured minus simulated force minus correction [N]
  NoiseModel noise;             ///< of that residual
  double zeros_as_force = 0.0;  ///< force offset if it explains both offsets [N], and its deviation
  double zeros_as_force_deviation = 0.0;

  /// Returns the column of a nuisance, -1 if it is not free.
  Eigen::Index column(Nuisance nuisance) const;
};

/// Returns the forces of all logs [N] over displacements [m], one vector per record at its sampling interval. A vector
/// that is longer than the record begins with a motion before the log.
using Simulate = std::function<std::vector<Eigen::VectorXd>(const std::vector<Eigen::VectorXd>&)>;

/// Returns true if a record may start while the machine runs, at speed or at a turning point, by the growth of its
/// first displacements. Returns false for a start at 0 without force, such as a ramp from rest.
bool startsInMotion(const log::Record& record);

/// Nuisances of a set of logs, with their priors.
class RigModel {
 public:
  /// `masks`: samples that count, one per record; empty: all. Throws std::invalid_argument if sizes differ.
  RigModel(std::vector<gap::PreparedRecord> records, std::vector<Mask> masks, const io::RigTolerances& tolerances);

  /// Returns columns and priors of the nuisances of each log, linearised at the simulated forces. `simulate` is called
  /// once with all displacements shifted by a hundredth of their range; if it is null, displacement offsets are not
  /// free. It is also called up to four times with a motion before each log that starts in motion or displaced: the
  /// first quarter of the log, or a motion from its highest displacement, its lowest displacement, or rest. The prior
  /// of the initial state is at most the error of the simulated force in the first samples. `points`: where to
  /// linearise.
  std::vector<RigColumns> columns(const std::vector<Eigen::VectorXd>& simulated, const Simulate& simulate,
                                  const std::vector<RigPoint>& points = {}) const;

  /// Estimates the values of one log by generalised least squares with priors, in `iterations` rounds of coloured noise
  /// by the residual and Huber's weights; without a round, by least squares with white noise of the residual's size.
  RigFit fit(std::size_t log, const RigColumns& columns, int iterations = 2) const;

  /// Fits all logs, linearised a second time at the values of the first fit.
  std::vector<RigFit> fitAll(const std::vector<Eigen::VectorXd>& simulated, const Simulate& simulate) const;

  /// Returns the findings of a fit that are significant (false in 1 of 1000 for each value) and large enough to matter
  /// (a tenth of the noise, RMS over the log), each with its 95 % interval. If the logs cannot distinguish an offset of
  /// the force from one of the displacement, both are reported as one `force_zero`.
  std::vector<RigFinding> findings(std::size_t log, const RigFit& fit) const;

  const std::vector<gap::PreparedRecord>& records() const { return records_; }
  const Mask& mask(std::size_t log) const { return masks_[log]; }

 private:
  double tolerance(Nuisance nuisance, const log::Record& record) const;
  double prior(Nuisance nuisance, const gap::PreparedRecord& record) const;
  std::vector<Eigen::VectorXd> simulateShifted(const Simulate& simulate, const std::vector<RigPoint>& points,
                                               double shift) const;
  std::vector<std::vector<Eigen::VectorXd>> simulateRunning(const Simulate& simulate,
                                                            const std::vector<RigPoint>& points) const;

  std::vector<gap::PreparedRecord> records_;
  std::vector<Mask> masks_;
  io::RigTolerances tolerances_;
};

}  // namespace rubber_suspension::measurement
