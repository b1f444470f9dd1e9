// Defines a record for fits, with possible errors of its rig and its weight. Throws nothing.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <utility>

#include "rubber_suspension/log/record.h"

namespace rubber_suspension::gap {

/// Prior distribution of the force that a rig may have added to one log. By default there is none.
struct RigPrior {
  /// Whitening columns N (numerics::whiteningColumns) for offset, delay, clock, gain, slow noise and the state of the
  /// component before the log, according to their priors. They are 0 where samples do not count, and may be missing.
  Eigen::MatrixXd columns;
  /// Force that one standard deviation of each error counts as in the fit, divided by the standard deviation of the
  /// force.
  double one_deviation = 0.0;
  /// Largest standard deviation [N] of a drift, or of noise slower than the motion, that counts as noise.
  double slow_noise = std::numeric_limits<double>::infinity();
  /// Standard deviation of an offset of the displacement [m].
  double displacement_zero = 0.0;
};

/// States which errors of the rig a single log has. These errors may have any size and are fitted with every model.
struct OwnErrors {
  bool gain = false;  ///< gain of the force channel
  bool zero = false;  ///< offset of the force
};

/// A record with its weight and the errors of its rig. By default the rig has no errors.
struct PreparedRecord : log::Record {
  PreparedRecord() = default;
  PreparedRecord(log::Record recorded, RigPrior prior = {}, double counts_as = 1.0)
      : log::Record(std::move(recorded)), rig(std::move(prior)), weight(counts_as) {}

  RigPrior rig;
  OwnErrors own;
  double weight = 1.0;  ///< weight of the mean squares of this record; the average over all logs is about 1

  /// Returns a residual or a derivative of the force [N] after removing the errors of the rig as far as their priors
  /// allow: r - N N'r (Frisch and Waugh, Econometrica 1, 1933, with a prior). Samples that do not count are 0.
  Eigen::VectorXd withoutRig(const Eigen::VectorXd& column) const;
};

}  // namespace rubber_suspension::gap
