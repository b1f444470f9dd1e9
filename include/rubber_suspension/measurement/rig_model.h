// Errors of a rig in each log (offsets, delay, clock, gain and a start in motion), estimated and removed by generalised
// least squares.
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

/// Error of the rig that one column of the least-squares system describes; the unit of its value is in brackets.
enum class Nuisance {
  force_zero,         ///< offset of the recorded force [N]
  displacement_zero,  ///< offset of the recorded displacement [m]
  delay,              ///< delay of the recorded force relative to the displacement, in the middle of the log [s]
  clock,              ///< growth of the delay per unit of time [-]
  gain,               ///< relative error of the recorded force, positive if too large [-]
  initial_state,  ///< force from an earlier motion [N]: first value of a decay with one relaxation time, or standard
                  ///< deviation of the prior times a share of the force after a typical motion
};

/// Point of linearisation of a log: the displacement offset and the delay that were already removed.
struct RigPoint {
  double displacement_zero = 0.0;  ///< [m]
  double delay = 0.0;              ///< [s]
  double clock = 0.0;              ///< [-]
};

/// Force that the rig may add to one log, linear in the values of its errors: recorded = base + columns * values.
struct RigColumns {
  Eigen::VectorXd base;             ///< simulated force [N]; with a point of linearisation, minus columns * point
  std::vector<Nuisance> nuisances;  ///< error that each column describes; initial_state may have several columns
  Eigen::MatrixXd columns;          ///< a row for each sample, a column for each error [N per unit of the value]
  Eigen::VectorXd priors;           ///< standard deviation of each value
};

/// Fit of the errors of the rig in one log.
struct RigFit {
  RigColumns rig;
  Eigen::VectorXd values;
  Eigen::MatrixXd covariance;   ///< covariance of the values, with their priors
  Eigen::VectorXd correction;   ///< force that the rig adds to the simulated one [N]
  Eigen::VectorXd residual;     ///< measured minus simulated force minus `correction` [N]
  NoiseModel noise;             ///< noise of `residual`
  double zeros_as_force = 0.0;  ///< force offset [N] if it alone explains both offsets, then its standard deviation
  double zeros_as_force_deviation = 0.0;

  /// Returns the index of the column of an error, or -1 if the error is not fitted.
  Eigen::Index column(Nuisance nuisance) const;
};

/// Returns the simulated forces [N] of all logs for given displacements [m], one vector per record at its sampling
/// interval. A vector longer than the record begins with a motion before the log.
using Simulate = std::function<std::vector<Eigen::VectorXd>(const std::vector<Eigen::VectorXd>&)>;

/// Returns true if the growth of the first displacements shows that the record may start while the rig is running, at
/// speed or at a turning point. Returns false for a start at 0 without force, such as a ramp from rest.
bool startsInMotion(const log::Record& record);

/// Errors of the rig in several logs, with their priors.
class RigModel {
 public:
  /// `masks`: samples that count, one mask per record, or none. Throws std::invalid_argument if sizes differ.
  RigModel(std::vector<gap::PreparedRecord> records, std::vector<Mask> masks, const io::RigTolerances& tolerances);

  /// Returns columns and priors of the errors of each log, linearised at the simulated forces. `simulate` is called
  /// once with all displacements shifted by a hundredth of their range; if it is null, displacement offsets are not
  /// fitted. It is also called up to four times with a motion before each log that starts in motion or displaced: the
  /// first quarter of the log, or a motion from its highest displacement, its lowest displacement, or rest. The prior
  /// of the initial state is at most the error of the simulated force in the first samples. `points`: points of
  /// linearisation.
  std::vector<RigColumns> columns(const std::vector<Eigen::VectorXd>& simulated, const Simulate& simulate,
                                  const std::vector<RigPoint>& points = {}) const;

  /// Fits one log by generalised least squares with priors. Each iteration estimates coloured noise and Huber's weights
  /// from the residual; 0 iterations assume white noise of the residual's size.
  RigFit fit(std::size_t log, const RigColumns& columns, int iterations = 2) const;

  /// Fits all logs, and fits them again after linearising at the values of the first fit.
  std::vector<RigFit> fitAll(const std::vector<Eigen::VectorXd>& simulated, const Simulate& simulate) const;

  /// Returns the findings of a fit that are significant (false for 1 of 1000 values) and whose RMS force is at least a
  /// tenth of the noise, each with its 95 % interval. If the logs cannot distinguish an offset of the force from one of
  /// the displacement, one finding `force_zero` reports both.
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
