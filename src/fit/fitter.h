// Simultaneous fits of a model's parameters and the effects of a hypothesis to a set of logs.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "fit/hypothesis.h"
#include "fit/hypothesis_forces.h"
#include "fit/model_parameters.h"
#include "fit/normal_equations.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

/// A fitted hypothesis. Gaps are RMS residuals in units of the standard deviation of the force.
struct Fit {
  ParameterVector parameters;
  double gap = 0.0;                    ///< in sample
  double penalty = 0.0;                ///< regularisation penalty of changed model parameters, as a gap
  double held_out = 0.0;               ///< gap on blocks that took no part in the fit, by cross validation
  std::vector<gap::PartError> blocks;  ///< held-out errors of these blocks
  std::vector<int> block_logs;         ///< the record that each is of

  /// Held-out gap and penalty together, by which fits compete.
  double score() const { return std::hypot(held_out, penalty); }
};

/// Fits hypotheses to one set of logs. Thread-safe once constructed; the model has to outlive it.
///
/// Model parameters are free, but a change from their configured values has a penalty in the order of the noise: what
/// the logs do not determine stays as it was specified, and an effect need not compete with model parameters that are
/// far from all that was specified.
class Fitter {
 public:
  Fitter(std::shared_ptr<const std::vector<log::Record>> records, const ModelParameters& model);
  Fitter(std::vector<log::Record> records, const ModelParameters& model)
      : Fitter(std::make_shared<const std::vector<log::Record>>(std::move(records)), model) {}

  const std::vector<log::Record>& records() const { return forces_.records(); }
  const ModelParameters& model() const { return forces_.model(); }
  const HypothesisForces& forces() const { return forces_; }

  /// The parameter vector of no change and no effect.
  ParameterVector configured(const Hypothesis& hypothesis) const;

  /// Residuals at a parameter vector and normal equations about it. Throws std::invalid_argument where it has no model.
  /// Terms that are not `active` get a column of zeros: they stay as they are. All are active where the list is empty.
  BlockGrams linearise(const Hypothesis& hypothesis, const ParameterVector& parameters,
                       const std::vector<bool>& active = {}, int threads = 1) const {
    return linearise(hypothesis, parameters, hypothesis.free_trends, active, threads);
  }

  /// Fit by Gauss-Newton steps within the bounds, from a start. `active`: terms that may move in the first step; all
  /// where it is empty.
  Fit fit(const Hypothesis& hypothesis, const ParameterVector& start, int iterations,
          const std::vector<bool>& active = {}) const;

  /// Where the scales arrive from a start while model parameters and trends stay as they are; terms that refine stay,
  /// too.
  ParameterVector scalesAlone(const Hypothesis& hypothesis, const ParameterVector& start, int iterations) const;

  /// Gap at a parameter vector, without any fit.
  double gapAt(const Hypothesis& hypothesis, const ParameterVector& parameters) const;

  /// Regularisation penalty of model parameters at these logarithms, as a gap.
  double penaltyOf(const Eigen::VectorXd& logarithms) const;

  /// Bounds on a step from a parameter vector: model parameters, terms, trends.
  void stepBounds(const Hypothesis& hypothesis, const ParameterVector& parameters, Eigen::Index columns,
                  Eigen::VectorXd& lower, Eigen::VectorXd& upper) const;

 private:
  BlockGrams linearise(const Hypothesis& hypothesis, const ParameterVector& parameters, bool trends,
                       const std::vector<bool>& active, int threads) const;
  /// Gauss-Newton steps from `parameters`, to where they end; normal equations there.
  BlockGrams descend(const Hypothesis& hypothesis, int iterations, bool trends, bool model_fixed,
                     const std::vector<bool>& first_active, ParameterVector& parameters) const;
  /// A step as far as it goes within the bounds; what it leaves of a term next to 0 is 0.
  static ParameterVector moved(const Hypothesis& hypothesis, const ParameterVector& parameters,
                               const Eigen::VectorXd& step);
  double cost(const Hypothesis& hypothesis, const ParameterVector& parameters) const;

  HypothesisForces forces_;
  std::vector<double> weights_;  // per record: 1/(standard deviation of the force sqrt(samples records))
  double force_noise_ = 0.0;     // of the measured force, in units of its standard deviation
};

}  // namespace rubber_suspension::fit
