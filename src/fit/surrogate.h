// Fit of a surrogate to what a model leaves of a set of logs: ridge regression on the functions of a residual element.
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
  bool predicts = false;  ///< it leaves less than the model does, unseen; without, all of its weights are 0
};

/// The ranges of its operators: the strokes, time constants and frequencies that the logs have.
element::ResidualBasis::Layout surrogateLayout(const std::vector<gap::PreparedRecord>& records);

/// Fit a surrogate to measured less simulated force. `simulated`: force of the model over each record's displacement as
/// recorded [N], which is what the surrogate sees as well.
///
/// The strength of the ridge, and whether characteristic and resonators are of use, are those that predict best what is
/// left out: a log each where there are at least three, blocks otherwise. Logs count alike; what the rig may have added
/// and samples that do not count are left out.
SurrogateFit fitSurrogate(const std::vector<gap::PreparedRecord>& records,
                          const std::vector<Eigen::VectorXd>& simulated, int threads);

}  // namespace rubber_suspension::fit
