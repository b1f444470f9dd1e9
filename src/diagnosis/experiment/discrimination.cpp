// Differences of explanations after a refit.
#include "diagnosis/experiment/discrimination.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "diagnosis/judge/numbers.h"
#include "fit/hypothesis_forces.h"
#include "fit/parallel.h"
#include "numerics/bounded_least_squares.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis::experiment {
namespace {

constexpr double kModelStep = 1e-4;   // of a logarithm, for difference quotients
constexpr double kTermStep = 0.02;    // of the typical scale
constexpr double kMostFloors = 10.0;  // count: what decides one question beyond doubt leaves the others open
constexpr std::size_t kRefitted = 8;  // motions that explanations are fitted to
constexpr double kLeastNoise = 1e-4;  // of the force

void withoutDirection(const Eigen::VectorXd& direction, Eigen::MatrixXd& columns) {
  const double square = direction.squaredNorm();
  if (square > 0.0) {
    columns -= direction / square * (direction.transpose() * columns).eval();
  }
}

// Without what is free in a new log: its zero; a ramp, where trends are; a multiple of the force, where a gain is.
Eigen::MatrixXd withoutFree(Eigen::MatrixXd columns, const fit::FreeInLog& free, const Eigen::VectorXd& force) {
  columns.rowwise() -= columns.colwise().mean().eval();
  const Eigen::VectorXd ramp = Eigen::VectorXd::LinSpaced(columns.rows(), -1.0, 1.0);
  Eigen::VectorXd gain = force.array() - force.mean();
  if (free.trend) {
    withoutDirection(ramp, columns);
    gain -= ramp * (ramp.dot(gain) / ramp.squaredNorm());
  }
  if (free.gain) {
    withoutDirection(gain, columns);
  }
  return columns;
}

}  // namespace

Discriminator::Discriminator(const fit::Fitter& fitter, const hypotheses::Search& search,
                             const std::vector<Explanation>& explanations, double force_limit, int threads)
    : fitter_(fitter),
      explanations_(explanations),
      noise_(std::max(search.noise, kLeastNoise) * search.excitation.force),
      accepted_(std::max(judge::fittedNumbers().accepted, search.discretisation)),
      force_limit_(force_limit),
      threads_(threads),
      played_(fitter.records()) {}

std::vector<element::ElementDescription> Discriminator::elementsOf(std::size_t explanation,
                                                                   const fit::ParameterVector& at) const {
  return fit::elementsOf(fitter_.model(), explanations_[explanation].fitted->hypothesis, at)
      .value_or(std::vector<element::ElementDescription>{});
}

void Discriminator::sayForces() {
  says_.assign(explanations_.size(), {});
  fit::parallelFor(says_.size(), threads_, [&](std::size_t e) {
    says_[e].force = played_.forces(elementsOf(e, explanations_[e].fitted->fit.parameters));
  });
}

std::vector<std::size_t> Discriminator::playable() const {
  std::vector<std::size_t> motions;
  for (std::size_t m = 0; m < played_.motions().size(); ++m) {
    const bool within = std::all_of(says_.begin(), says_.end(), [&](const Says& says) {
      return says.force[m].allFinite() && says.force[m].cwiseAbs().maxCoeff() <= force_limit_;
    });
    if (within) {
      motions.push_back(m);
    }
  }
  return motions;
}

double Discriminator::floorOf(double force_deviation) const { return std::max(noise_, accepted_ * force_deviation); }

// Expected least difference in floors before any refit: an upper bound of that after it.
double Discriminator::unrefitted(std::size_t motion) const {
  double expected = 0.0;
  for (std::size_t right = 0; right < says_.size(); ++right) {
    const Eigen::VectorXd& force = says_[right].force[motion];
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t wrong = 0; wrong < says_.size(); ++wrong) {
      if (wrong != right) {
        least = std::min(least, gap::standardDeviation(force - says_[wrong].force[motion]));
      }
    }
    expected +=
        explanations_[right].probability * std::min(kMostFloors, least / floorOf(gap::standardDeviation(force)));
  }
  return expected;
}

// The best of each kind, as far as there is time to refit: motions of a kind are taken by the same parameters.
std::vector<std::size_t> Discriminator::promising(const std::vector<std::size_t>& motions) const {
  std::vector<std::pair<double, std::size_t>> order;
  for (const std::size_t motion : motions) {
    order.emplace_back(-unrefitted(motion), motion);
  }
  std::sort(order.begin(), order.end());
  std::map<std::string, int> of_kind;
  std::vector<std::size_t> chosen;
  for (int round = 1; chosen.size() < std::min(kRefitted, motions.size()); ++round) {
    for (const auto& [negative, motion] : order) {
      const bool taken = std::find(chosen.begin(), chosen.end(), motion) != chosen.end();
      int& count = of_kind[played_.motions()[motion]->kind];
      if (!taken && count < round && chosen.size() < kRefitted) {
        chosen.push_back(motion);
        ++count;
      }
    }
  }
  return chosen;
}

void Discriminator::findNormalEquations() {
  normal_.resize(explanations_.size());
  for (std::size_t e = 0; e < normal_.size(); ++e) {
    const hypotheses::FittedHypothesis& fitted = *explanations_[e].fitted;
    const auto blocks = fitter_.linearise(fitted.hypothesis, fitted.fit.parameters, movable(e), threads_);
    const Eigen::Index unknowns = blocks.unknowns();
    Normal& normal = normal_[e];
    normal.gram = blocks.sum.topLeftCorner(unknowns, unknowns);
    normal.bounds = fitter_.stepBounds(fitted.hypothesis, fitted.fit.parameters, unknowns);
    normal.free = fitted.hypothesis.free_in_log;
  }
}

// Whether the force of a term is the same beside all others.
bool Discriminator::isPlayedAlone(std::size_t explanation, Eigen::Index term) const {
  const fit::Hypothesis& hypothesis = explanations_[explanation].fitted->hypothesis;
  return hypothesis.terms[static_cast<std::size_t>(term)].on_rig ||
         (hypothesis.isAdditive() && fitter_.forces().isAdditive());
}

// As in fits, terms at nothing whose force would have to be simulated beside the others stay there.
std::vector<bool> Discriminator::movable(std::size_t explanation) const {
  const Eigen::VectorXd& scales = explanations_[explanation].fitted->fit.parameters.scales;
  std::vector<bool> movable;
  for (Eigen::Index t = 0; t < scales.size(); ++t) {
    movable.push_back(scales[t] != 0.0 || isPlayedAlone(explanation, t));
  }
  return movable;
}

// By difference quotients; terms that add up with all else are played alone.
void Discriminator::sayDerivatives(std::size_t explanation) {
  const hypotheses::FittedHypothesis& fitted = *explanations_[explanation].fitted;
  const fit::ParameterVector& at = fitted.fit.parameters;
  const Eigen::Index of_model = at.model.size();
  const Eigen::Index count = of_model + at.scales.size();
  const std::vector<bool> moves = movable(explanation);
  Says& says = says_[explanation];
  for (const Eigen::VectorXd& force : says.force) {
    says.derivatives.emplace_back(Eigen::MatrixXd::Zero(force.size(), count));
  }
  fit::parallelFor(static_cast<std::size_t>(count), threads_, [&](std::size_t column) {
    const auto j = static_cast<Eigen::Index>(column);
    fit::ParameterVector moved = at;
    double step = kModelStep;
    std::vector<element::ElementDescription> elements;
    bool alone = false;
    if (j < of_model) {
      moved.model[j] += step;
      elements = elementsOf(explanation, moved);
      if (elements.empty()) {
        step = -step;
        moved.model[j] = at.model[j] + step;
        elements = elementsOf(explanation, moved);
      }
    } else if (const std::size_t place = column - static_cast<std::size_t>(of_model); moves[place]) {
      const fit::BasisTerm& term = fitted.hypothesis.terms[place];
      double& scale = moved.scales[j - of_model];
      alone = isPlayedAlone(explanation, j - of_model);
      step = (alone ? 1.0 : scale + term.typical > term.upper ? -kTermStep : kTermStep) * term.typical;
      scale += step;
      elements = alone ? std::vector{term.at(step)} : elementsOf(explanation, moved);
    }
    if (elements.empty()) {  // no model on either side, or a term that stays: it cannot move
      return;
    }
    const auto forces = played_.forces(elements);
    for (std::size_t m = 0; m < forces.size(); ++m) {
      says.derivatives[m].col(j) = (alone ? forces[m] : (forces[m] - says.force[m]).eval()) / step;
    }
  });
  for (std::size_t m = 0; m < says.force.size(); ++m) {
    says.derivatives[m] = withoutFree(says.derivatives[m], fitted.hypothesis.free_in_log, says.force[m]);
    says.grams.emplace_back(says.derivatives[m].transpose() * says.derivatives[m]);
  }
}

// RMS force by which the wrong explanation is off, wherever it puts that: on the motion, or on the logs before [N].
double Discriminator::leftAfterRefit(std::size_t right, std::size_t wrong, std::size_t motion) const {
  const Normal& normal = normal_[wrong];
  const Eigen::VectorXd& force = says_[right].force[motion];
  const Eigen::VectorXd& said = says_[wrong].force[motion];
  const double deviation = gap::standardDeviation(force);
  const auto samples = static_cast<double>(force.size());
  const auto logs = static_cast<double>(fitter_.records().size());
  // Relative to the force of the new log, which weighs as much as each of the others.
  const double unit = 1.0 / (deviation * std::sqrt(samples));
  const Eigen::VectorXd difference = unit * withoutFree(force - said, normal.free, said);
  const Eigen::MatrixXd& columns = says_[wrong].derivatives[motion];
  Eigen::MatrixXd gram = logs * normal.gram;
  gram.topLeftCorner(columns.cols(), columns.cols()) += unit * unit * says_[wrong].grams[motion];
  Eigen::VectorXd moment = Eigen::VectorXd::Zero(gram.rows());
  moment.head(columns.cols()) = unit * (columns.transpose() * difference);
  const Eigen::VectorXd step = numerics::boundedLeastSquares(gram, moment, normal.bounds.lower, normal.bounds.upper);
  const double cost = difference.squaredNorm() - 2.0 * step.dot(moment) + step.dot(gram * step);
  return deviation * std::sqrt(std::clamp(cost, 0.0, difference.squaredNorm()));
}

Discrimination Discriminator::weigh(std::size_t motion) const {
  const auto logs = static_cast<double>(fitter_.records().size());
  Discrimination result;
  result.experiment = played_.motions()[motion];
  for (std::size_t right = 0; right < explanations_.size(); ++right) {
    const double deviation = gap::standardDeviation(says_[right].force[motion]);
    double least = std::numeric_limits<double>::infinity();
    std::size_t nearest = right;
    std::vector<double> left;
    for (std::size_t wrong = 0; wrong < explanations_.size(); ++wrong) {
      const double off = wrong == right ? 0.0 : leftAfterRefit(right, wrong, motion);
      left.push_back(std::pow(off / deviation, 2));
      if (wrong != right && off < least) {
        least = off;
        nearest = wrong;
      }
    }
    const double probability = explanations_[right].probability;
    result.difference = right == 0 ? least : result.difference;
    result.floors += probability * std::min(kMostFloors, least / floorOf(deviation));
    result.probability += probability * standsAlone(right, explanations_, left, logs);
    result.nearest = right == 0 ? nearest : result.nearest;
  }
  return result;
}

Discrimination Discriminator::best(const std::vector<Experiment>& menu) {
  std::vector<const Experiment*> motions;
  for (const Experiment& experiment : menu) {
    motions.push_back(&experiment);
  }
  played_.play(motions);
  sayForces();
  const std::vector<std::size_t> chosen = promising(playable());
  if (chosen.empty()) {
    return {};
  }
  std::vector<const Experiment*> few;
  for (const std::size_t motion : chosen) {
    few.push_back(motions[motion]);
  }
  for (Says& says : says_) {
    std::vector<Eigen::VectorXd> forces;
    for (const std::size_t motion : chosen) {
      forces.push_back(std::move(says.force[motion]));
    }
    says.force = std::move(forces);
  }
  played_.play(few);
  if (normal_.empty()) {
    findNormalEquations();
  }
  for (std::size_t e = 0; e < explanations_.size(); ++e) {
    sayDerivatives(e);
  }
  Discrimination best;
  for (std::size_t motion = 0; motion < few.size(); ++motion) {
    const Discrimination here = weigh(motion);
    best = best.experiment == nullptr || here.floors > best.floors ? here : best;
  }
  return best;
}

}  // namespace rubber_suspension::diagnosis::experiment
