// Simultaneous fits of model parameters and basis terms.
#include "fit/fitter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "fit/bounded_least_squares.h"
#include "fit/parallel.h"

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

Fitter::Fitter(std::shared_ptr<const std::vector<log::Record>> records, const ModelParameters& model)
    : forces_(std::move(records), model) {
  const auto count = static_cast<double>(this->records().size());
  for (const log::Record& record : this->records()) {
    weights_.push_back(1.0 / (record.force_deviation * std::sqrt(record.counted() * count)));
    force_noise_ += std::max(gap::whiteNoiseFloor(record, record.force), kLeastNoise) / count;
  }
}

ParameterVector Fitter::configured(const Hypothesis& hypothesis) const {
  return {Eigen::VectorXd::Zero(model().size()),
          Eigen::VectorXd::Zero(static_cast<Eigen::Index>(hypothesis.terms.size()))};
}

double Fitter::gapAt(const Hypothesis& hypothesis, const ParameterVector& parameters) const {
  const auto simulated = forces_.at(hypothesis, parameters);
  if (!simulated) {
    return std::numeric_limits<double>::infinity();
  }
  double sum = 0.0;
  for (std::size_t r = 0; r < records().size(); ++r) {
    const log::Record& record = records()[r];
    sum += std::pow(weights_[r], 2) * record.withoutRig(record.force - (*simulated)[r]).squaredNorm();
  }
  return std::isfinite(sum) ? std::sqrt(sum) : std::numeric_limits<double>::infinity();
}

BlockGrams Fitter::linearise(const Hypothesis& hypothesis, const ParameterVector& parameters, bool trends,
                             const std::vector<bool>& active, int threads) const {
  const auto base = forces_.at(hypothesis, parameters);
  if (!base) {
    throw std::invalid_argument("the model has no solution at the parameters to be linearised about");
  }
  const auto size = static_cast<std::size_t>(model().size());
  std::vector<ForceColumn> columns(size + hypothesis.terms.size());
  parallelFor(columns.size(), threads, [&](std::size_t j) {
    if (j < size) {
      columns[j] = forces_.modelColumn(hypothesis, parameters, static_cast<Eigen::Index>(j), *base);
    } else if (active.empty() || active[j - size]) {
      columns[j] = forces_.termColumn(hypothesis, parameters, j - size, *base);
    }
  });
  BlockGrams result = normalEquations(records(), weights_, *base, columns, trends, threads);
  const Eigen::Index last = result.gram[0].rows() - 1;
  result.prior = Eigen::MatrixXd::Zero(last + 1, last + 1);
  for (Eigen::Index j = 0; j < model().size(); ++j) {
    result.prior(j, j) = std::pow(kPrior * force_noise_, 2);
    result.prior(j, last) = result.prior(last, j) = -result.prior(j, j) * parameters.model[j];
  }
  result.sumUp();
  return result;
}

void Fitter::stepBounds(const Hypothesis& hypothesis, const ParameterVector& parameters, Eigen::Index columns,
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

double Fitter::penaltyOf(const Eigen::VectorXd& logarithms) const {
  return kPenalty * force_noise_ * logarithms.norm();
}

double Fitter::cost(const Hypothesis& hypothesis, const ParameterVector& parameters) const {
  return std::hypot(gapAt(hypothesis, parameters), kPrior * force_noise_ * parameters.model.norm());
}

ParameterVector Fitter::moved(const Hypothesis& hypothesis, const ParameterVector& parameters,
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

BlockGrams Fitter::descend(const Hypothesis& hypothesis, int iterations, bool trends, bool model_fixed,
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

ParameterVector Fitter::scalesAlone(const Hypothesis& hypothesis, const ParameterVector& start, int iterations) const {
  std::vector<bool> active(hypothesis.terms.size());
  std::transform(hypothesis.terms.begin(), hypothesis.terms.end(), active.begin(),
                 [](const BasisTerm& term) { return !term.refines; });
  ParameterVector parameters = start;
  descend(hypothesis, iterations, false, true, active, parameters);
  return parameters;
}

Fit Fitter::fit(const Hypothesis& hypothesis, const ParameterVector& start, int iterations,
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
    result.blocks.push_back({errors[b], blocks.weight[b]});
    held_out += errors[b] * blocks.weight[b];
  }
  result.block_logs = blocks.record;
  // A law that gives way under some log (a series compliance about a softening component) is no explanation of it.
  result.held_out = std::isfinite(held_out) ? std::sqrt(held_out) : std::numeric_limits<double>::infinity();
  result.penalty = penaltyOf(result.parameters.model);
  result.gap = gapAt(hypothesis, result.parameters);
  return result;
}

}  // namespace rubber_suspension::fit
