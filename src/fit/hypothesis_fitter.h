// Simultaneous fits of a model's parameters and the effects of a hypothesis, to logs or to a table.
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
  double chi_squared = 0.0;  ///< departure of the model from prior knowledge (ModelParameters::departures())
  double departure = 0.0;    ///< the departure as a gap
  /// Gap on blocks that took no part in the fit, by cross validation.
  double held_out = std::numeric_limits<double>::infinity();
  std::vector<gap::PartError> blocks;  ///< held-out errors of these blocks

  /// Returns held-out gap and departure combined, by which fits compete.
  double score() const { return std::hypot(held_out, departure); }
};

/// The longest step of the logarithm of a model parameter: the force is far from linear in a longer one.
constexpr double kLongestStep = 0.4;

/// Termination of a fit.
struct FitLimits {
  int iterations = 0;
  /// The fit ends if even its linearisation predicts a gap above this.
  double reach = std::numeric_limits<double>::infinity();
  std::vector<bool> active = {};  ///< terms that may move in the first step; empty: all
  /// The fit ends if its steps are too small to reach this gap.
  double needed = std::numeric_limits<double>::infinity();
  int threads = 1;
  /// Held-out blocks are predicted about the end of the fit; otherwise about the point to which a further step would
  /// lead, which estimates the optimum of a fit that has run out of steps.
  bool about_its_end = false;
};

/// Fits hypotheses to measurements: Gauss-Newton steps within bounds, and cross validation by blocks. A derived class
/// defines the measurement and the residual. Thread-safe once constructed; the model has to outlive it.
///
/// Model parameters are free, but prior knowledge of the component counts like a measurement: a departure by one
/// standard deviation costs as much as a certain gap, whatever the noise. Parameters that the measurement does not
/// determine therefore stay as specified.
class HypothesisFitter {
 public:
  virtual ~HypothesisFitter() = default;
  HypothesisFitter(const HypothesisFitter&) = delete;
  HypothesisFitter& operator=(const HypothesisFitter&) = delete;

  const ModelParameters& model() const { return model_; }

  /// Returns the parameter vector without changes and effects.
  ParameterVector configured(const Hypothesis& hypothesis) const;

  /// Returns the normal equations about a parameter vector. Throws std::invalid_argument if the model has no solution
  /// there. Terms that are not `active` get a column of zeros, so that they do not change; empty: all are active.
  BlockGrams linearise(const Hypothesis& hypothesis, const ParameterVector& parameters,
                       const std::vector<bool>& active = {}, int threads = 1) const {
    return linearise(hypothesis, startAt(hypothesis, parameters), active, threads);
  }

  /// Returns the normal equations by folds, for each entry of `free`, which is then free in each log.
  std::vector<BlockGrams> lineariseFolds(const Hypothesis& hypothesis, const ParameterVector& parameters,
                                         const std::vector<PerLogNuisances>& free, int threads) const {
    return linearise(hypothesis, startAt(hypothesis, parameters), {{}, free, Kept::folds, threads});
  }

  /// Fits by Gauss-Newton steps within the bounds, from a start.
  Fit fit(const Hypothesis& hypothesis, const ParameterVector& start, const FitLimits& limits) const;

  /// Fits the model alone and returns the best fit from all its starts (ModelParameters::starts()).
  Fit fitAlone(const FitLimits& limits) const;

  /// Fits the scales alone: model parameters are kept and nothing is free in a log. Terms that refine are kept in the
  /// first step.
  ParameterVector scalesAlone(const Hypothesis& hypothesis, const ParameterVector& start, int iterations) const;

  /// Returns the gap at a parameter vector, without a fit; infinite if the model has no solution there.
  double gapAt(const Hypothesis& hypothesis, const ParameterVector& parameters) const;

  /// Frees offsets of the displacement if they change the force of a hypothesis at a parameter vector.
  virtual void freeZeros(const ParameterVector& /*parameters*/, Hypothesis& /*hypothesis*/) const {}

  /// Frees a factor on the friction of each log, with the friction at a parameter vector; does nothing for a table.
  virtual void freeFactors(const ParameterVector& /*parameters*/, Hypothesis& /*hypothesis*/) const {}

  /// Returns the gap that counts as much as a departure of one standard deviation.
  double oneDeviation() const { return one_deviation_; }

  /// Returns bounds on a step from a parameter vector: model parameters, terms, nuisance parameters of each log.
  numerics::Limits stepBounds(const Hypothesis& hypothesis, const ParameterVector& parameters,
                              Eigen::Index unknowns) const;

 protected:
  HypothesisFitter(const ModelParameters& model, double one_deviation) : model_(model), one_deviation_(one_deviation) {}

  /// Options of a linearisation.
  struct Linearised {
    std::vector<bool> active;           ///< terms whose columns are computed, the others are 0; empty: all
    std::vector<PerLogNuisances> free;  ///< nuisance parameters of each log; one result for each entry
    Kept kept;
    int threads;
  };

 private:
  /// Returns the forces of a hypothesis; nullopt if the model has no solution.
  virtual std::optional<gap::Forces> simulate(const Hypothesis& hypothesis,
                                              const ParameterVector& parameters) const = 0;
  /// Returns the gap of a hypothesis with these forces.
  virtual double gapOf(const Hypothesis& hypothesis, const gap::Forces& forces) const = 0;
  /// Returns the normal equations about parameters whose forces are `base`, without the prior of model parameters.
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
  /// Returns the point at a vector; throws std::invalid_argument if the model has no solution there.
  Place startAt(const Hypothesis& hypothesis, const ParameterVector& start) const;
  /// Moves by a step, or by part of it; returns false if none improves the fit noticeably.
  bool improve(const Hypothesis& hypothesis, const Eigen::VectorXd& step, Place& place) const;
  /// Iterates until a step improves the fit too little or a limit is reached, and returns the normal equations there.
  /// `longest`: largest change of the logarithm of a model parameter in one step.
  BlockGrams descend(const Hypothesis& hypothesis, const FitLimits& limits, double longest, Place& place) const;
  /// Returns the parameters after a step; scales stay within their bounds, and negligible ones become 0.
  static ParameterVector moved(const Hypothesis& hypothesis, const ParameterVector& parameters,
                               const Eigen::VectorXd& step);

  const ModelParameters& model_;
  double one_deviation_;
};

}  // namespace rubber_suspension::fit
