// Fits of a model's parameters together with the effects of a hypothesis, to logs or to a table.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "fit/hypothesis.h"
#include "fit/hypothesis_forces.h"
#include "fit/model_parameters.h"
#include "fit/normal_equations.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::fit {

/// A fitted hypothesis. Gaps are RMS residuals in units of the standard deviation of the force.
struct Fit {
  ParameterVector parameters;
  double gap = std::numeric_limits<double>::infinity();  ///< gap on the samples of the fit
  double chi_squared = 0.0;  ///< departure of the model from prior knowledge (ModelParameters::departures())
  double departure = 0.0;    ///< `chi_squared` expressed as a gap
  /// Gap on blocks that were held out of the fit, by cross validation.
  double held_out = std::numeric_limits<double>::infinity();
  std::vector<gap::PartError> blocks;  ///< held-out error of each block

  /// Returns held-out gap and departure combined. Fits are compared by this value.
  double score() const { return std::hypot(held_out, departure); }
};

/// Largest change of the logarithm of a model parameter in one step; in a longer one the force is far from linear.
constexpr double kLongestStep = 0.4;

struct FitLimits {
  int iterations = 0;
  /// The fit ends if even a linearised step predicts a larger gap.
  double reach = std::numeric_limits<double>::infinity();
  std::vector<bool> active = {};  ///< terms that may change in the first step; empty for all
  /// The fit ends if its steps are too small to reach this gap.
  double needed = std::numeric_limits<double>::infinity();
  int threads = 1;
  /// If true, held-out blocks are predicted at the last point of the fit. If false, they are predicted at the point
  /// that a further step would reach, which estimates the optimum of a fit that ran out of steps.
  bool about_its_end = false;
};

/// Fits hypotheses to measurements: Gauss-Newton steps within bounds, and cross validation by blocks. A derived class
/// defines the measurement and the residual. Thread-safe once constructed; the model has to outlive it.
///
/// Model parameters are fitted, but prior knowledge of the component counts like a measurement: a departure of one
/// standard deviation costs as much as a certain gap, whatever the noise. Parameters that the measurement does not
/// determine therefore keep their specified values.
class HypothesisFitter {
 public:
  virtual ~HypothesisFitter() = default;
  HypothesisFitter(const HypothesisFitter&) = delete;
  HypothesisFitter& operator=(const HypothesisFitter&) = delete;

  const ModelParameters& model() const { return model_; }

  /// Returns the parameter vector of the configured model without effects.
  ParameterVector configured(const Hypothesis& hypothesis) const;

  /// Returns the normal equations at a parameter vector. `active`: terms that may change, empty for all; the columns of
  /// other terms are zero. Throws std::invalid_argument if the model has no solution there.
  BlockGrams linearise(const Hypothesis& hypothesis, const ParameterVector& parameters,
                       const std::vector<bool>& active = {}, int threads = 1) const {
    return linearise(hypothesis, startAt(hypothesis, parameters), active, threads);
  }

  /// Returns normal equations by folds, one for each entry of `free`, the nuisance parameters fitted to each log.
  std::vector<BlockGrams> lineariseFolds(const Hypothesis& hypothesis, const ParameterVector& parameters,
                                         const std::vector<PerLogNuisances>& free, int threads) const {
    return linearise(hypothesis, startAt(hypothesis, parameters), {{}, free, Kept::folds, threads});
  }

  /// Fits by Gauss-Newton steps within the bounds, beginning at `start`.
  Fit fit(const Hypothesis& hypothesis, const ParameterVector& start, const FitLimits& limits) const;

  /// Fits the model alone and returns the best fit from all its starts (ModelParameters::starts()).
  Fit fitAlone(const FitLimits& limits) const;

  /// Fits only the scales: model parameters are kept, and no nuisance parameter is fitted. In the first step, terms
  /// with BasisTerm::refines are also kept.
  ParameterVector scalesAlone(const Hypothesis& hypothesis, const ParameterVector& start, int iterations) const;

  /// Returns the gap at a parameter vector, without a fit; infinite if the model has no solution there.
  double gapAt(const Hypothesis& hypothesis, const ParameterVector& parameters) const;

  /// Adds displacement offsets to the hypothesis if they change its force at a parameter vector.
  virtual void freeZeros(const ParameterVector& /*parameters*/, Hypothesis& /*hypothesis*/) const {}

  /// Adds a factor on the friction of each log, simulated at a parameter vector. Does nothing for a table.
  virtual void freeFactors(const ParameterVector& /*parameters*/, Hypothesis& /*hypothesis*/) const {}

  /// Returns the gap that counts as much as a departure of one standard deviation from prior knowledge.
  double oneDeviation() const { return one_deviation_; }

  /// Returns bounds on a step from a parameter vector: model parameters, terms, and nuisance parameters of each log.
  numerics::Limits stepBounds(const Hypothesis& hypothesis, const ParameterVector& parameters,
                              Eigen::Index unknowns) const;

 protected:
  HypothesisFitter(const ModelParameters& model, double one_deviation) : model_(model), one_deviation_(one_deviation) {}

  struct Linearised {
    std::vector<bool> active;           ///< terms whose columns are computed (empty: all); other columns are 0
    std::vector<PerLogNuisances> free;  ///< nuisance parameters of each log; each entry gives one result
    Kept kept;
    int threads;
  };

 private:
  /// Returns the forces of a hypothesis; nullopt if the model has no solution.
  virtual std::optional<gap::Forces> simulate(const Hypothesis& hypothesis,
                                              const ParameterVector& parameters) const = 0;
  /// Returns the gap of a hypothesis with these forces.
  virtual double gapOf(const Hypothesis& hypothesis, const gap::Forces& forces) const = 0;
  /// Returns the normal equations at parameters whose forces are `base`, without the prior of model parameters.
  virtual std::vector<BlockGrams> normalEquationsAbout(const Hypothesis& hypothesis, const ParameterVector& parameters,
                                                       const gap::Forces& base, const Linearised& how) const = 0;

  /// A point of the Gauss-Newton iteration.
  struct Place {
    ParameterVector parameters;
    gap::Forces forces;
    double cost = 0.0;  ///< gap and departure combined
  };
  BlockGrams linearise(const Hypothesis& hypothesis, const Place& place, const std::vector<bool>& active,
                       int threads) const {
    return std::move(linearise(hypothesis, place, {active, {hypothesis.free_in_log}, Kept::blocks, threads}).front());
  }
  std::vector<BlockGrams> linearise(const Hypothesis& hypothesis, const Place& place, const Linearised& how) const;
  Place placeAt(const Hypothesis& hypothesis, ParameterVector parameters) const;
  /// Returns the point of a parameter vector. Throws std::invalid_argument if the model has no solution there.
  Place startAt(const Hypothesis& hypothesis, const ParameterVector& start) const;
  /// Moves by a step or a part of it. Returns false if no part improves the fit noticeably.
  bool improve(const Hypothesis& hypothesis, const Eigen::VectorXd& step, Place& place) const;
  /// Iterates until a step improves the fit too little or a limit is reached, and returns the normal equations at this
  /// point. `longest`: largest change of the logarithm of a model parameter in one step.
  BlockGrams descend(const Hypothesis& hypothesis, const FitLimits& limits, double longest, Place& place) const;
  /// Returns the parameters after a step. Scales stay within their bounds, and negligible scales become 0.
  static ParameterVector moved(const Hypothesis& hypothesis, const ParameterVector& parameters,
                               const Eigen::VectorXd& step);

  const ModelParameters& model_;
  double one_deviation_;
};

}  // namespace rubber_suspension::fit
