// The force that a rig adds to each log beside the component: offsets, delay, clock, gain and a start in motion;
// estimated and removed by generalised least squares.
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

/// The meaning of a column; its value is in the unit in brackets.
enum class Nuisance {
  force_zero,         ///< by which the recorded force is too high [N]
  displacement_zero,  ///< by which the recorded displacement is too high [m]
  delay,              ///< of the recorded force behind the displacement, in the middle of the log [s]
  clock,              ///< by how much that delay grows per time [-]
  gain,               ///< by which the recorded force is too large [-]
  initial_state,  ///< force left from before the log [N]: one that decays with one relaxation time, at its start; or
                  ///< the prior's standard deviation times a share of what a motion before the log would have left
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

/// The rig's part in one log.
struct RigFit {
  RigColumns rig;
  Eigen::VectorXd values;
  Eigen::MatrixXd covariance;   ///< of the values, prior included
  Eigen::VectorXd correction;   ///< what the rig adds to the simulated force [N]
  Eigen::VectorXd residual;     ///< measured minus simulated force minus correction [N]
  NoiseModel noise;             ///< of that residual
  double zeros_as_force = 0.0;  ///< force zero where all of both zeros is one of the force [N], and its deviation
  double zeros_as_force_deviation = 0.0;

  /// Column of a nuisance, -1 where it is not free.
  Eigen::Index column(Nuisance nuisance) const;
};

/// Force of all logs [N] over displacements [m], one vector per record at its sampling interval. A vector may be longer
/// than the record: it then has a motion before the log.
using Simulate = std::function<std::vector<Eigen::VectorXd>(const std::vector<Eigen::VectorXd>&)>;

/// True where a record may start while the machine runs: at speed or at a turning point, by how the way grows at first.
/// Not where it starts at 0 without force, as a ramp from rest does. The force at the first samples bounds the initial
/// state.
bool startsInMotion(const log::Record& record);

/// The nuisances of a set of logs, and how wide each may be.
class RigModel {
 public:
  /// `masks`: samples that count, one per record; empty: all. Throws std::invalid_argument where sizes differ.
  RigModel(std::vector<gap::PreparedRecord> records, std::vector<Mask> masks, const io::RigTolerances& tolerances);

  /// Columns and priors of each log about simulated forces. `simulate` is called once with all displacements shifted
  /// by a hundredth of their stroke (without it, displacement zeros are not free), and three times more, where a log
  /// starts in motion, with a motion before it: its own first part, or from its highest or lowest displacement.
  /// `points`: where to linearise.
  std::vector<RigColumns> columns(const std::vector<Eigen::VectorXd>& simulated, const Simulate& simulate,
                                  const std::vector<RigPoint>& points = {}) const;

  /// The values of one log by generalised least squares with priors: noise of the residual's own colour, Huber's
  /// weights, `iterations` rounds of both; without a round, least squares with the residual's own size as noise.
  RigFit fit(std::size_t log, const RigColumns& columns, int iterations = 2) const;

  /// All logs at once, linearised a second time where the first values are.
  std::vector<RigFit> fitAll(const std::vector<Eigen::VectorXd>& simulated, const Simulate& simulate) const;

  /// The findings of a fit beyond chance (1 in 1000 for each value) and large enough to matter (a tenth of the noise,
  /// RMS over the log), each with its 95 % interval. If the logs cannot distinguish an offset of the force from one of
  /// the displacement, both are reported as one `force_zero`.
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
