// Gauss-Newton steps and cross validation.
#include "fit/hypothesis_fitter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace rubber_suspension::fit {
namespace {

constexpr double kEnoughGain = 1e-3;  // of the gap, for a further step
constexpr double kLongestStep = 0.4;  // of a logarithm: the model is far from linear beyond
constexpr int kMostHalvings = 6;      // of a step that does not lead down
constexpr double kPenalty = 5.0;      // of a logarithm's change, times the noise of the force, between hypotheses
constexpr double kPrior = 2.0;        // the same within a fit, where it must not keep parameters from what logs tell
constexpr double kNothing = 1e-9;     // of the typical scale: a term of this scale is left out

std::vector<double> gainsOf(const Hypothesis& hypothesis, Eigen::Index model, const BlockGrams& blocks,
                            const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  const Eigen::VectorXd x = solveAll(blocks.sum, lower, upper);
  const Eigen::Index of_log = hypothesis.free_in_log.count();
  std::vector<double> gains;
  for (Eigen::Index j = model + static_cast<Eigen::Index>(hypothesis.terms.size()) + of_log - 1; j < x.size();
       j += of_log) {
    gains.push_back(x[j]);
  }
  return gains;
}

// The gap that a step promises, were the force linear.
double promised(const Eigen::MatrixXd& total, const Eigen::VectorXd& step) {
  const Eigen::Index last = step.size();
  const auto gram = total.topLeftCorner(last, last);
  return std::sqrt(std::max(0.0, total(last, last) - step.dot(2.0 * total.col(last).head(last) - gram * step)));
}

// The common part of the gains of all logs is that of the term, where there is one.
void takeOutCommonGain(const Hypothesis& hypothesis, Fit& fit) {
  const auto term = std::find_if(hypothesis.terms.begin(), hypothesis.terms.end(),
                                 [](const BasisTerm& other) { return other.is_gain; });
  if (term == hypothesis.terms.end()) {
    return;
  }
  const double mean = std::accumulate(fit.gains.begin(), fit.gains.end(), 0.0) / static_cast<double>(fit.gains.size());
  double& scale = fit.parameters.scales[term - hypothesis.terms.begin()];
  const double common = std::clamp((1.0 + scale) * (1.0 + mean), 1.0 + term->lower, 1.0 + term->upper);
  for (double& gain : fit.gains) {
    gain = (1.0 + gain) * (1.0 + scale) / common - 1.0;
  }
  scale = common - 1.0;
}

}  // namespace

void HypothesisFitter::setNoise(double noise) { noise_ = std::max(noise, kLeastNoise); }

ParameterVector HypothesisFitter::configured(const Hypothesis& hypothesis) const {
  return {Eigen::VectorXd::Zero(model().size()),
          Eigen::VectorXd::Zero(static_cast<Eigen::Index>(hypothesis.terms.size()))};
}

double HypothesisFitter::gapAt(const Hypothesis& hypothesis, const ParameterVector& parameters) const {
  const auto forces = simulate(hypothesis, parameters);
  return forces ? gapOf(hypothesis, *forces) : std::numeric_limits<double>::infinity();
}

BlockGrams HypothesisFitter::linearise(const Hypothesis& hypothesis, const Place& place, FreeInLog free,
                                       const std::vector<bool>& active, int threads) const {
  BlockGrams result = normalEquationsAbout(hypothesis, place.parameters, place.forces, free, active, threads);
  const Eigen::Index last = result.gram[0].rows() - 1;
  if (result.prior.size() == 0) {
    result.prior = Eigen::MatrixXd::Zero(last + 1, last + 1);
  }
  for (Eigen::Index j = 0; j < model().size(); ++j) {
    result.prior(j, j) = std::pow(kPrior * noise_ * model().firmness(j), 2);
    result.prior(j, last) = result.prior(last, j) = -result.prior(j, j) * place.parameters.model[j];
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

double HypothesisFitter::priorOf(const Eigen::VectorXd& logarithms) const {
  double squares = 0.0;
  for (Eigen::Index j = 0; j < logarithms.size(); ++j) {
    squares += std::pow(model().firmness(j) * logarithms[j], 2);
  }
  return kPrior * noise_ * std::sqrt(squares);
}

HypothesisFitter::Place HypothesisFitter::placeAt(const Hypothesis& hypothesis, ParameterVector parameters) const {
  Place place{std::move(parameters), {}, std::numeric_limits<double>::infinity()};
  if (auto forces = simulate(hypothesis, place.parameters)) {
    place.forces = std::move(*forces);
    place.cost = std::hypot(gapOf(hypothesis, place.forces), priorOf(place.parameters.model));
  }
  return place;
}

HypothesisFitter::Place HypothesisFitter::startAt(const Hypothesis& hypothesis, const ParameterVector& start) const {
  Place place = placeAt(hypothesis, start);
  if (place.forces.empty()) {
    throw std::invalid_argument("the model has no solution at the parameters that a fit starts from");
  }
  return place;
}

bool HypothesisFitter::improve(const Hypothesis& hypothesis, const Eigen::VectorXd& step, Place& place) const {
  double factor = 1.0;
  for (int halving = 0; halving < kMostHalvings; ++halving, factor *= 0.5) {
    Place tried = placeAt(hypothesis, moved(hypothesis, place.parameters, factor * step));
    if (tried.cost < place.cost) {
      const bool much = place.cost - tried.cost > kEnoughGain * place.cost;
      place = std::move(tried);
      return much;
    }
  }
  return false;
}

BlockGrams HypothesisFitter::descend(const Hypothesis& hypothesis, const FitLimits& limits, FreeInLog free,
                                     bool model_fixed, Place& place) const {
  BlockGrams blocks = linearise(hypothesis, place, free, limits.active, 1);
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;
  const Eigen::Index unknowns = blocks.gram[0].rows() - 1;
  const Eigen::Index size = model().size();
  for (int iteration = 0; iteration < limits.iterations; ++iteration) {
    stepBounds(hypothesis, place.parameters, unknowns, lower, upper);
    const double longest = model_fixed ? 0.0 : kLongestStep;
    lower.head(size) = lower.head(size).cwiseMax(-longest);
    upper.head(size) = upper.head(size).cwiseMin(longest);
    const Eigen::VectorXd step = solveAll(blocks.sum, lower, upper);
    if (!step.allFinite()) {
      break;
    }
    const double promise = std::hypot(promised(blocks.sum, step), priorOf(place.parameters.model));
    const bool hopeless = iteration > 0 && promise > limits.reach;
    if (hopeless || place.cost - promise < kEnoughGain * place.cost || !improve(hypothesis, step, place)) {
      break;
    }
    // Terms that the first step leaves at nothing take no further part: their force would have to be simulated each
    // time.
    std::vector<bool> active(hypothesis.terms.size());
    for (std::size_t t = 0; t < active.size(); ++t) {
      active[t] = hypothesis.terms[t].additive || place.parameters.scales[static_cast<Eigen::Index>(t)] != 0.0;
    }
    blocks = linearise(hypothesis, place, free, active, 1);
  }
  return blocks;
}

ParameterVector HypothesisFitter::scalesAlone(const Hypothesis& hypothesis, const ParameterVector& start,
                                              int iterations) const {
  std::vector<bool> active(hypothesis.terms.size());
  std::transform(hypothesis.terms.begin(), hypothesis.terms.end(), active.begin(),
                 [](const BasisTerm& term) { return !term.refines; });
  Hypothesis nothing_free = hypothesis;
  nothing_free.free_in_log = {};
  nothing_free.by_zero = nullptr;
  Place place = startAt(nothing_free, start);
  descend(nothing_free, {iterations, std::numeric_limits<double>::infinity(), active}, {}, true, place);
  return place.parameters;
}

Fit HypothesisFitter::fit(const Hypothesis& hypothesis, const ParameterVector& start, const FitLimits& limits) const {
  Fit result;
  Place place = startAt(hypothesis, start);
  const BlockGrams blocks = descend(hypothesis, limits, hypothesis.free_in_log, false, place);
  result.gap = gapOf(hypothesis, place.forces);
  result.parameters = std::move(place.parameters);
  const Eigen::Index unknowns = blocks.gram[0].rows() - 1;
  std::vector<Eigen::Index> columns(static_cast<std::size_t>(unknowns));
  std::iota(columns.begin(), columns.end(), 0);
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;
  stepBounds(hypothesis, result.parameters, unknowns, lower, upper);
  if (hypothesis.free_in_log.gain) {
    result.gains = gainsOf(hypothesis, model().size(), blocks, lower, upper);
    takeOutCommonGain(hypothesis, result);
  }
  const std::vector<double> errors = crossValidate(blocks, columns, lower, upper);
  double held_out = 0.0;
  for (std::size_t b = 0; b < errors.size(); ++b) {
    result.blocks.push_back({errors[b], blocks.weight[b], blocks.record[b]});
    held_out += errors[b] * blocks.weight[b];
  }
  // A law that gives way under some log (a series compliance about a softening component) is no explanation of it.
  result.held_out = std::isfinite(held_out) ? std::sqrt(held_out) : std::numeric_limits<double>::infinity();
  result.penalty = penaltyOf(result.parameters.model);
  return result;
}

}  // namespace rubber_suspension::fit
