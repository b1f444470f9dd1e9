// A record for fits, with possible errors of its rig and its weight. Throws nothing.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <utility>

#include "rubber_suspension/log/record.h"

namespace rubber_suspension::gap {

/// Prior of the force that a rig may have added to one log; by default none.
struct RigPrior {
  /// Whitening columns N (numerics::whiteningColumns) of offset, lag, gain, slow noise and of the component's state
  /// before the log, each within its prior; 0 where samples do not count; may be empty.
  Eigen::MatrixXd columns;
  /// Error as which one standard deviation of any of them counts, over the force's standard deviation.
  double one_deviation = 0.0;
  /// Largest standard deviation [N] of noise slower than the motion, or of a drift, that counts as noise.
  double slow_noise = std::numeric_limits<double>::infinity();
  /// Standard deviation of an offset of the displacement [m].
  double displacement_zero = 0.0;
};

/// Errors of the rig in a single log, of any size, which are fitted with every model.
struct OwnErrors {
  bool gain = false;  ///< the gain of the force's channel
  bool zero = false;  ///< the offset of the force
};

/// A record, the errors of its rig and its weight. By default the rig has no errors.
struct PreparedRecord : log::Record {
  PreparedRecord() = default;
  PreparedRecord(log::Record recorded, RigPrior prior = {}, double counts_as = 1.0)
      : log::Record(std::move(recorded)), rig(std::move(prior)), weight(counts_as) {}

  RigPrior rig;
  OwnErrors own;
  double weight = 1.0;  ///< of its mean squares relative to those of other logs, about 1 on average

  /// Returns a residual or a derivative of the force [N] without errors of the rig, r - N N'r, as far as their priors
  /// let them explain r (Frisch and Waugh, Econometrica 1, 1933, with a prior). Samples that do not count are 0.
  Eigen::VectorXd withoutRig(const Eigen::VectorXd& column) const;
};

}  // namespace rubber_suspension::gap
