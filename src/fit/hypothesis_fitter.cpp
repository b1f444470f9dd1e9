// Gauss-Newton steps and cross validation.
#include "fit/hypothesis_fitter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace rubber_suspension::fit {
namespace {

constexpr double kEnoughGain = 1e-3;       // smallest relative reduction of the gap for a further step
constexpr double kSlow = 0.2;              // least share of the reduction still needed that a step has to achieve
constexpr int kMostHalvings = 6;           // halvings of a step that does not reduce the cost
constexpr double kNegligibleScale = 1e-9;  // share of the typical scale; a term of a smaller scale is omitted

// Returns the mean offset (or gain) of the logs that the parameters do not explain. `of_columns`: mean offset to which
// each column of the least-squares system is equivalent; the last column is the residual.
double meanLeft(const Eigen::VectorXd& of_columns, const Eigen::VectorXd& unknowns) {
  const Eigen::Index last = unknowns.size();
  return of_columns[last] - of_columns.head(last).dot(unknowns);
}

// Moves the common part of the offsets (or gains) of all logs to the term for all logs, if there is one.
void takeCommon(const Hypothesis& hypothesis, const BlockGrams& blocks, const Eigen::VectorXd& unknowns,
                ParameterVector& parameters) {
  for (std::size_t t = 0; t < hypothesis.terms.size(); ++t) {
    const BasisTerm& term = hypothesis.terms[t];
    double& scale = parameters.scales[static_cast<Eigen::Index>(t)];
    if (term.is_offset && hypothesis.free_in_log.offset) {
      scale = std::clamp(scale + meanLeft(blocks.mean_offset, unknowns), term.lower, term.upper);
    } else if (term.is_gain && hypothesis.free_in_log.gain) {
      const double gain = (1.0 + scale) * (1.0 + meanLeft(blocks.mean_gain, unknowns)) - 1.0;
      scale = std::clamp(gain, term.lower, term.upper);
    }
  }
}

}  // namespace

ParameterVector HypothesisFitter::configured(const Hypothesis& hypothesis) const {
  return {Eigen::VectorXd::Zero(model().size()),
          Eigen::VectorXd::Zero(static_cast<Eigen::Index>(hypothesis.terms.size()))};
}

double HypothesisFitter::gapAt(const Hypothesis& hypothesis, const ParameterVector& parameters) const {
  const auto forces = simulate(hypothesis, parameters);
  return forces ? gapOf(hypothesis, *forces) : std::numeric_limits<double>::infinity();
}

std::vector<BlockGrams> HypothesisFitter::linearise(const Hypothesis& hypothesis, const Place& place,
                                                    const Linearised& how) const {
  std::vector<BlockGrams> results = normalEquationsAbout(hypothesis, place.parameters, place.forces, how);
  const Eigen::Index size = model().size();
  const Eigen::MatrixXd slopes = one_deviation_ * model().departureSlopes(place.parameters.model);
  const Eigen::VectorXd left = -one_deviation_ * model().departures(place.parameters.model);
  for (BlockGrams& result : results) {
    result.prior.topLeftCorner(size, size) = slopes.transpose() * slopes;
    result.prior.rightCols<1>().head(size) = slopes.transpose() * left;
    result.prior.bottomRows<1>().head(size) = result.prior.rightCols<1>().head(size).transpose();
    result.prior.bottomRightCorner<1, 1>().setConstant(left.squaredNorm());
    result.addPrior();
  }
  return results;
}

numerics::Limits HypothesisFitter::stepBounds(const Hypothesis& hypothesis, const ParameterVector& parameters,
                                              Eigen::Index unknowns) const {
  const auto infinite = Eigen::VectorXd::Constant(unknowns, std::numeric_limits<double>::infinity());
  const Eigen::Index size = model().size();
  numerics::Limits bounds{-infinite, infinite};
  const double free = hypothesis.keepsParameters() ? 0.0 : 1.0;
  bounds.lower.head(size) = free * (-model().bounds() - parameters.model);
  bounds.upper.head(size) = free * (model().bounds() - parameters.model);
  for (std::size_t t = 0; t < hypothesis.terms.size(); ++t) {
    const auto i = static_cast<Eigen::Index>(t);
    bounds.lower[size + i] = hypothesis.terms[t].lower - parameters.scales[i];
    bounds.upper[size + i] = hypothesis.terms[t].upper - parameters.scales[i];
  }
  return bounds;
}

ParameterVector HypothesisFitter::moved(const Hypothesis& hypothesis, const ParameterVector& parameters,
                                        const Eigen::VectorXd& step) {
  ParameterVector result = parameters;
  result.model += step.head(result.model.size());
  result.scales += step.segment(result.model.size(), result.scales.size());
  for (std::size_t t = 0; t < hypothesis.terms.size(); ++t) {  // keeps rounding errors within the bounds
    const BasisTerm& term = hypothesis.terms[t];
    auto& scale = result.scales[static_cast<Eigen::Index>(t)];
    scale = std::clamp(scale, term.lower, term.upper);
    scale = std::abs(scale) < kNegligibleScale * term.typical ? 0.0 : scale;
  }
  return result;
}

HypothesisFitter::Place HypothesisFitter::placeAt(const Hypothesis& hypothesis, ParameterVector parameters) const {
  Place place{std::move(parameters), {}, std::numeric_limits<double>::infinity()};
  if (auto forces = simulate(hypothesis, place.parameters)) {
    place.forces = std::move(*forces);
    const double departure = one_deviation_ * model().departures(place.parameters.model).norm();
    place.cost = std::hypot(gapOf(hypothesis, place.forces), departure);
  }
  return place;
}

HypothesisFitter::Place HypothesisFitter::startAt(const Hypothesis& hypothesis, const ParameterVector& start) const {
  Place place = placeAt(hypothesis, start);
  if (place.forces.empty()) {
    throw std::invalid_argument("the model has no solution at the starting parameters of the fit");
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

BlockGrams HypothesisFitter::descend(const Hypothesis& hypothesis, const FitLimits& limits, double longest,
                                     Place& place) const {
  BlockGrams blocks = linearise(hypothesis, place, limits.active, limits.threads);
  for (int iteration = 0; iteration < limits.iterations; ++iteration) {
    const numerics::Limits all = stepBounds(hypothesis, place.parameters, blocks.unknowns());
    numerics::Limits bounds = all;
    auto lower = bounds.lower.head(model().size());
    auto upper = bounds.upper.head(model().size());
    lower = lower.cwiseMax(-longest);
    upper = upper.cwiseMin(longest);
    const Eigen::VectorXd step = solve(blocks.sum, bounds);
    if (!step.allFinite()) {
      break;
    }
    // Returns the cost after a step if the force were linear.
    const auto promiseOf = [&](const Eigen::VectorXd& taken) {
      return std::sqrt(std::max(0.0, squaresLeft(blocks.sum, taken)));
    };
    const double promise = promiseOf(step);
    // A cost that the bounds exclude for one step may still be reached in several steps.
    const bool hopeless =
        iteration > 0 && promise > limits.reach && !(promiseOf(solve(blocks.sum, all)) <= limits.reach);
    const bool too_slow = place.cost - promise < kSlow * (place.cost - limits.needed);
    if (hopeless || too_slow || place.cost - promise < kEnoughGain * place.cost || !improve(hypothesis, step, place)) {
      break;
    }
    // Terms that the first step sets to 0 are omitted afterwards, because each step would have to simulate them.
    std::vector<bool> active(hypothesis.terms.size());
    for (std::size_t t = 0; t < active.size(); ++t) {
      active[t] = hypothesis.terms[t].additive || place.parameters.scales[static_cast<Eigen::Index>(t)] != 0.0;
    }
    blocks = linearise(hypothesis, place, active, limits.threads);
  }
  return blocks;
}

ParameterVector HypothesisFitter::scalesAlone(const Hypothesis& hypothesis, const ParameterVector& start,
                                              int iterations) const {
  FitLimits limits{iterations};
  for (const BasisTerm& term : hypothesis.terms) {
    limits.active.push_back(!term.refines);
  }
  Hypothesis nothing_free = hypothesis;
  nothing_free.free_in_log = {};
  Place place = startAt(nothing_free, start);
  descend(nothing_free, limits, 0.0, place);
  return place.parameters;
}

Fit HypothesisFitter::fit(const Hypothesis& hypothesis, const ParameterVector& start, const FitLimits& limits) const {
  Fit result;
  Place place = startAt(hypothesis, start);
  const BlockGrams blocks = descend(hypothesis, limits, kLongestStep, place);
  result.gap = gapOf(hypothesis, place.forces);
  result.parameters = std::move(place.parameters);
  const numerics::Limits bounds = stepBounds(hypothesis, result.parameters, blocks.unknowns());
  const auto step = [&](const Eigen::MatrixXd& gram) { return solve(gram, bounds); };
  const Eigen::VectorXd further = step(blocks.sum);
  if (hypothesis.free_in_log.ofTerms()) {
    takeCommon(hypothesis, blocks, further, result.parameters);
  }
  // At the end of a fit a further step no longer reduces the cost, because the law deviates from its linearisation.
  // Blocks are then predicted without this step.
  const Eigen::VectorXd not_taken = limits.about_its_end ? further : Eigen::VectorXd::Zero(further.size());
  const std::vector<double> errors =
      crossValidate(blocks, [&](const Eigen::MatrixXd& gram) { return Eigen::VectorXd(step(gram) - not_taken); });
  double held_out = 0.0;
  for (std::size_t b = 0; b < errors.size(); ++b) {
    result.blocks.push_back({errors[b], blocks.weight[b], blocks.record[b]});
    held_out += errors[b] * blocks.weight[b];
  }
  // Held-out errors below those of the fit are due to chance, and are raised to the errors of the fit.
  if (const double fitted = result.gap * result.gap; limits.about_its_end && held_out > 0.0 && held_out < fitted) {
    for (gap::PartError& block : result.blocks) {
      block.error *= fitted / held_out;
    }
    held_out = fitted;
  }
  // A law without a finite force in a log (a series compliance about a softening component) does not explain the log.
  result.held_out = std::isfinite(held_out) ? std::sqrt(held_out) : std::numeric_limits<double>::infinity();
  result.chi_squared = model().departures(result.parameters.model).squaredNorm();
  result.departure = one_deviation_ * std::sqrt(result.chi_squared);
  return result;
}

Fit HypothesisFitter::fitAlone(const FitLimits& limits) const {
  Fit best;
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::VectorXd& start : model().starts()) {
    if (!model().elements(start)) {
      continue;
    }
    Fit fitted = fit({}, {start, {}}, limits);
    const double cost = std::hypot(fitted.gap, fitted.departure);
    if (cost < least) {
      least = cost;
      best = std::move(fitted);
    }
  }
  return best;
}

}  // namespace rubber_suspension::fit
