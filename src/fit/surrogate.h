// Fit of a surrogate to the residuals of a model: ridge regression on the functions of a residual element.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubber_suspension/element/residual.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::fit {

/// Mean square errors of a block of a log that took no part in the fit, in units of the force's variance.
struct UnseenBlock {
  int record = 0;
  double weight = 0.0;  ///< share of the block in all samples; each log counts alike
  double before = 0.0;  ///< of the model
  double after = 0.0;   ///< with a surrogate that was fitted without the block
};

/// A fitted surrogate.
struct SurrogateFit {
  element::ElementDescription element;
  std::vector<UnseenBlock> unseen;
  bool predicts = false;  ///< it reduces the held-out error; otherwise all of its weights are 0
};

/// Returns a layout whose operators cover the strokes, time constants and frequencies of the logs.
element::ResidualBasis::Layout surrogateLayout(const std::vector<gap::PreparedRecord>& records);

/// Fits a surrogate to measured minus simulated force. `simulated`: force of the model over each record's displacement
/// as recorded [N], which the surrogate has as well.
///
/// The strength of the ridge, and the use of characteristic and resonators, have the least held-out error: each log in
/// turn is held out if there are at least three, otherwise blocks. Logs count alike; errors of the rig and samples that
/// do not count are excluded.
SurrogateFit fitSurrogate(const std::vector<gap::PreparedRecord>& records,
                          const std::vector<Eigen::VectorXd>& simulated, int threads);

}  // namespace rubber_suspension::fit
