// Gauss-Newton steps and cross validation.
#include "fit/hypothesis_fitter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "fit/bounded_least_squares.h"

namespace rubber_suspension::fit {
namespace {

constexpr double kEnoughGain = 1e-3;  // of the gap, for a further step
constexpr double kLongestStep = 0.4;  // of a logarithm: the model is far from linear beyond
constexpr int kMostHalvings = 6;      // of a step that does not lead down
constexpr double kPenalty = 5.0;      // of a logarithm's change, times the noise of the force, between hypotheses
constexpr double kPrior = 2.0;        // the same within a fit, where it must not keep parameters from what logs tell
constexpr double kLeastNoise = 1e-3;  // of the force's standard deviation: no model is better than that
constexpr double kNothing = 1e-9;     // of the typical scale: a term of this scale is left out

}  // namespace

void HypothesisFitter::setNoise(double noise) { noise_ = std::max(noise, kLeastNoise); }

ParameterVector HypothesisFitter::configured(const Hypothesis& hypothesis) const {
  return {Eigen::VectorXd::Zero(model().size()),
          Eigen::VectorXd::Zero(static_cast<Eigen::Index>(hypothesis.terms.size()))};
}

BlockGrams HypothesisFitter::linearise(const Hypothesis& hypothesis, const ParameterVector& parameters, bool trends,
                                       const std::vector<bool>& active, int threads) const {
  BlockGrams result = normalEquationsAt(hypothesis, parameters, trends, active, threads);
  const Eigen::Index last = result.gram[0].rows() - 1;
  result.prior = Eigen::MatrixXd::Zero(last + 1, last + 1);
  for (Eigen::Index j = 0; j < model().size(); ++j) {
    result.prior(j, j) = std::pow(kPrior * noise_, 2);
    result.prior(j, last) = result.prior(last, j) = -result.prior(j, j) * parameters.model[j];
  }
  result.sumUp();
  return result;
}

void HypothesisFitter::stepBounds(const Hypothesis& hypothesis, const ParameterVector& parameters, Eigen::Index columns,
                                  Eigen::VectorXd& lower, Eigen::VectorXd& upper) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Eigen::Index size = model().size();
  lower = Eigen::VectorXd::Constant(columns, -kInfinity);
  upper = Eigen::VectorXd::Constant(columns, kInfinity);
  for (Eigen::Index j = 0; j < size; ++j) {
    lower[j] = -model().bound(j) - parameters.model[j];
    upper[j] = model().bound(j) - parameters.model[j];
  }
  for (std::size_t t = 0; t < hypothesis.terms.size(); ++t) {
    const auto i = static_cast<Eigen::Index>(t);
    lower[size + i] = hypothesis.terms[t].lower - parameters.scales[i];
    upper[size + i] = hypothesis.terms[t].upper - parameters.scales[i];
  }
}

double HypothesisFitter::penaltyOf(const Eigen::VectorXd& logarithms) const {
  return kPenalty * noise_ * logarithms.norm();
}

double HypothesisFitter::cost(const Hypothesis& hypothesis, const ParameterVector& parameters) const {
  return std::hypot(gapAt(hypothesis, parameters), kPrior * noise_ * parameters.model.norm());
}

ParameterVector HypothesisFitter::moved(const Hypothesis& hypothesis, const ParameterVector& parameters,
                                        const Eigen::VectorXd& step) {
  ParameterVector result = parameters;
  result.model += step.head(result.model.size());
  result.scales += step.segment(result.model.size(), result.scales.size());
  for (std::size_t t = 0; t < hypothesis.terms.size(); ++t) {  // rounding must not leave the bounds
    const BasisTerm& term = hypothesis.terms[t];
    auto& scale = result.scales[static_cast<Eigen::Index>(t)];
    scale = std::clamp(scale, term.lower, term.upper);
    scale = std::abs(scale) < kNothing * term.typical ? 0.0 : scale;
  }
  return result;
}

BlockGrams HypothesisFitter::descend(const Hypothesis& hypothesis, int iterations, bool trends, bool model_fixed,
                                     const std::vector<bool>& first_active, ParameterVector& parameters) const {
  BlockGrams blocks = linearise(hypothesis, parameters, trends, first_active, 1);
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;
  double least = cost(hypothesis, parameters);
  const Eigen::Index unknowns = blocks.gram[0].rows() - 1;
  const Eigen::Index size = model().size();
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const Eigen::MatrixXd& total = blocks.sum;
    stepBounds(hypothesis, parameters, unknowns, lower, upper);
    const double longest = model_fixed ? 0.0 : kLongestStep;
    lower.head(size) = lower.head(size).cwiseMax(-longest);
    upper.head(size) = upper.head(size).cwiseMin(longest);
    const Eigen::VectorXd step =
        boundedLeastSquares(total.topLeftCorner(unknowns, unknowns), total.col(unknowns).head(unknowns), lower, upper);
    if (!step.allFinite()) {
      break;
    }
    double factor = 1.0;
    bool improved = false;
    for (int halving = 0; halving < kMostHalvings && !improved; ++halving, factor *= 0.5) {
      const ParameterVector tried = moved(hypothesis, parameters, factor * step);
      const double tried_cost = cost(hypothesis, tried);
      if (tried_cost < least) {
        improved = least - tried_cost > kEnoughGain * least;
        least = tried_cost;
        parameters = tried;
        if (!improved) {
          break;
        }
      }
    }
    if (!improved) {
      break;
    }
    // What the first step leaves at nothing takes no further part: its force would have to be simulated each time.
    std::vector<bool> active(hypothesis.terms.size());
    for (std::size_t t = 0; t < active.size(); ++t) {
      active[t] = hypothesis.terms[t].additive || parameters.scales[static_cast<Eigen::Index>(t)] != 0.0;
    }
    blocks = linearise(hypothesis, parameters, trends, active, 1);
  }
  return blocks;
}

ParameterVector HypothesisFitter::scalesAlone(const Hypothesis& hypothesis, const ParameterVector& start,
                                              int iterations) const {
  std::vector<bool> active(hypothesis.terms.size());
  std::transform(hypothesis.terms.begin(), hypothesis.terms.end(), active.begin(),
                 [](const BasisTerm& term) { return !term.refines; });
  ParameterVector parameters = start;
  descend(hypothesis, iterations, false, true, active, parameters);
  return parameters;
}

Fit HypothesisFitter::fit(const Hypothesis& hypothesis, const ParameterVector& start, int iterations,
                          const std::vector<bool>& active) const {
  Fit result;
  result.parameters = start;
  const BlockGrams blocks = descend(hypothesis, iterations, hypothesis.free_trends, false, active, result.parameters);
  const Eigen::Index unknowns = blocks.gram[0].rows() - 1;
  std::vector<Eigen::Index> columns(static_cast<std::size_t>(unknowns));
  std::iota(columns.begin(), columns.end(), 0);
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;
  stepBounds(hypothesis, result.parameters, unknowns, lower, upper);
  const std::vector<double> errors = crossValidate(blocks, columns, lower, upper);
  double held_out = 0.0;
  for (std::size_t b = 0; b < errors.size(); ++b) {
    result.blocks.push_back({errors[b], blocks.weight[b], blocks.record[b]});
    held_out += errors[b] * blocks.weight[b];
  }
  // A law that gives way under some log (a series compliance about a softening component) is no explanation of it.
  result.held_out = std::isfinite(held_out) ? std::sqrt(held_out) : std::numeric_limits<double>::infinity();
  result.penalty = penaltyOf(result.parameters.model);
  result.gap = gapAt(hypothesis, result.parameters);
  return result;
}

}  // namespace rubber_suspension::fit
