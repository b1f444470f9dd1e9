// Simultaneous fits of a model's parameters and the effects of a hypothesis, whatever was measured.
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
  double gap = std::numeric_limits<double>::infinity();  ///< in sample
  double chi_squared = 0.0;  ///< departure of the model from what is known of it (ModelParameters::departures())
  double departure = 0.0;    ///< the same as a gap
  /// Gap on blocks that took no part in the fit, by cross validation.
  double held_out = std::numeric_limits<double>::infinity();
  std::vector<gap::PartError> blocks;  ///< held-out errors of these blocks

  /// Held-out gap and departure together, by which fits compete.
  double score() const { return std::hypot(held_out, departure); }
};

/// The longest step of the logarithm of a model parameter: the force is far from linear in it beyond.
constexpr double kLongestStep = 0.4;

/// Termination of a fit.
struct FitLimits {
  int iterations = 0;
  /// A step that promises to leave more than this, as a gap, is the last.
  double reach = std::numeric_limits<double>::infinity();
  std::vector<bool> active = {};  ///< terms that may move in the first step; all where it is empty
  /// A fit that gains too little to come down to this, as a gap, ends.
  double needed = std::numeric_limits<double>::infinity();
  int threads = 1;
  /// Held-out blocks are predicted about where the fit ends; else about where a further step promises to lead, which
  /// estimates the end of a fit whose steps ran out.
  bool about_its_end = false;
};

/// Fits hypotheses to measurements: Gauss-Newton steps within bounds, and cross validation by blocks. A derived class
/// defines the measurement and the residual. Thread-safe once constructed; the model has to outlive it.
///
/// Model parameters are free, but what is known of the component beforehand is a measurement like any other: a
/// departure by one standard deviation costs as much as a certain gap, whatever the noise of the measurement. So what
/// the measurement does not determine stays as it was specified.
class HypothesisFitter {
 public:
  virtual ~HypothesisFitter() = default;
  HypothesisFitter(const HypothesisFitter&) = delete;
  HypothesisFitter& operator=(const HypothesisFitter&) = delete;

  const ModelParameters& model() const { return model_; }

  /// The parameter vector of no change and no effect.
  ParameterVector configured(const Hypothesis& hypothesis) const;

  /// Residuals at a parameter vector and normal equations about it. Throws std::invalid_argument where it has no model.
  /// Terms that are not `active` get a column of zeros: they stay as they are. All are active where the list is empty.
  BlockGrams linearise(const Hypothesis& hypothesis, const ParameterVector& parameters,
                       const std::vector<bool>& active = {}, int threads = 1) const {
    return linearise(hypothesis, startAt(hypothesis, parameters), active, threads);
  }

  /// Linearises by folds alone, with each of these free in each log.
  std::vector<BlockGrams> lineariseFolds(const Hypothesis& hypothesis, const ParameterVector& parameters,
                                         const std::vector<PerLogNuisances>& free, int threads) const {
    return linearise(hypothesis, startAt(hypothesis, parameters), {{}, free, Kept::folds, threads});
  }

  /// Fit by Gauss-Newton steps within the bounds, from a start.
  Fit fit(const Hypothesis& hypothesis, const ParameterVector& start, const FitLimits& limits) const;

  /// Fit of the model alone, the best from all its starts (ModelParameters::starts()).
  Fit fitAlone(const FitLimits& limits) const;

  /// Where the scales arrive from a start while model parameters stay as they are and nothing is free in a log; terms
  /// that refine stay, too.
  ParameterVector scalesAlone(const Hypothesis& hypothesis, const ParameterVector& start, int iterations) const;

  /// Gap at a parameter vector, without any fit; infinite where it has no model.
  double gapAt(const Hypothesis& hypothesis, const ParameterVector& parameters) const;

  /// Free zeros of the displacement where they change the force of a hypothesis at a parameter vector.
  virtual void freeZeros(const ParameterVector& /*parameters*/, Hypothesis& /*hypothesis*/) const {}

  /// Free a factor on the friction of each log, by what friction does at a parameter vector; nothing for a table.
  virtual void freeFactors(const ParameterVector& /*parameters*/, Hypothesis& /*hypothesis*/) const {}

  /// The gap that a departure of one standard deviation counts as.
  double oneDeviation() const { return one_deviation_; }

  /// Bounds on a step from a parameter vector: model parameters, terms, what is free in each log.
  numerics::Limits stepBounds(const Hypothesis& hypothesis, const ParameterVector& parameters,
                              Eigen::Index unknowns) const;

 protected:
  HypothesisFitter(const ModelParameters& model, double one_deviation) : model_(model), one_deviation_(one_deviation) {}

  /// Normal equations as they are asked for.
  struct Linearised {
    std::vector<bool> active;           ///< terms that are not get a column of zeros; all are where it is empty
    std::vector<PerLogNuisances> free;  ///< in each log; one result for each
    Kept kept;
    int threads;
  };

 private:
  /// Forces of a hypothesis; nothing where it has no model.
  virtual std::optional<gap::Forces> simulate(const Hypothesis& hypothesis,
                                              const ParameterVector& parameters) const = 0;
  /// Gap of a hypothesis whose forces are these.
  virtual double gapOf(const Hypothesis& hypothesis, const gap::Forces& forces) const = 0;
  /// Normal equations about a parameter vector whose forces are `base`, but for the prior of model parameters.
  virtual std::vector<BlockGrams> normalEquationsAbout(const Hypothesis& hypothesis, const ParameterVector& parameters,
                                                       const gap::Forces& base, const Linearised& how) const = 0;

  /// Where Gauss-Newton steps are.
  struct Place {
    ParameterVector parameters;
    gap::Forces forces;
    double cost = 0.0;  ///< gap and departure together
  };
  BlockGrams linearise(const Hypothesis& hypothesis, const Place& place, const std::vector<bool>& active,
                       int threads) const {
    return std::move(linearise(hypothesis, place, {active, {hypothesis.free_in_log}, Kept::blocks, threads}).front());
  }
  std::vector<BlockGrams> linearise(const Hypothesis& hypothesis, const Place& place, const Linearised& how) const;
  Place placeAt(const Hypothesis& hypothesis, ParameterVector parameters) const;
  /// Starts at a vector; throws std::invalid_argument if there is no model.
  Place startAt(const Hypothesis& hypothesis, const ParameterVector& start) const;
  /// Moves by a step, or by part of it; returns false if none improves the fit noticeably.
  bool improve(const Hypothesis& hypothesis, const Eigen::VectorXd& step, Place& place) const;
  /// Gauss-Newton steps to where they end; normal equations there. `longest`: step of a logarithm.
  BlockGrams descend(const Hypothesis& hypothesis, const FitLimits& limits, double longest, Place& place) const;
  /// A step as far as it goes within the bounds; what it leaves of a term next to 0 is 0.
  static ParameterVector moved(const Hypothesis& hypothesis, const ParameterVector& parameters,
                               const Eigen::VectorXd& step);

  const ModelParameters& model_;
  double one_deviation_;
};

}  // namespace rubber_suspension::fit
