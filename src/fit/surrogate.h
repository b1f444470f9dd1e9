// Fit of a surrogate to the residuals of a model: ridge regression on the functions of a residual element.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubber_suspension/element/residual.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::fit {

/// Mean square errors of a block of a log that was held out of the fit, in units of the variance of the force.
struct UnseenBlock {
  int record = 0;
  double weight = 0.0;  ///< share of the block in all samples; all logs count alike
  double before = 0.0;  ///< error of the model alone
  double after = 0.0;   ///< error with a surrogate that was fitted without the block
};

struct SurrogateFit {
  element::ElementDescription element;
  std::vector<UnseenBlock> unseen;
  bool predicts = false;  ///< true if the surrogate reduces the held-out error; otherwise all weights are 0
};

/// Returns a layout whose operators cover the strokes, time constants and frequencies of the logs.
element::ResidualBasis::Layout surrogateLayout(const std::vector<gap::PreparedRecord>& records);

/// Fits a surrogate to measured minus simulated force. `simulated`: force of the model over the recorded displacement
/// of each record [N]. The surrogate also acts on the recorded displacement.
///
/// The strength of the ridge and the use of characteristic and resonators minimise the held-out error. If there are at
/// least three logs, each is held out in turn; otherwise blocks are held out. All logs count alike. Errors of the rig
/// and samples that do not count are excluded.
SurrogateFit fitSurrogate(const std::vector<gap::PreparedRecord>& records,
                          const std::vector<Eigen::VectorXd>& simulated, int threads);

}  // namespace rubber_suspension::fit
