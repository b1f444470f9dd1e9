// Differences of explanations after a refit.
#include "diagnosis/experiment/discrimination.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "diagnosis/judge/numbers.h"
#include "fit/hypothesis_forces.h"
#include "fit/parallel.h"
#include "numerics/bounded_least_squares.h"
#include "numerics/gram.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis::experiment {
namespace {

constexpr double kModelStep = 1e-4;   // of a logarithm, for difference quotients
constexpr double kTermStep = 0.02;    // of the typical scale
constexpr double kMostFloors = 10.0;  // count: what decides one question beyond doubt leaves the others open
constexpr std::size_t kRefitted = 8;  // motions that explanations are fitted to
constexpr std::size_t kAtOnce = 2;    // of these, before it is known whether a further one can tell more
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
    says_[e].on_motion.resize(says_[e].force.size());
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

// The best of each kind, as far as there is time to refit: motions of a kind are taken by the same parameters. Those
// that may tell most first.
std::vector<Discriminator::Bounded> Discriminator::promising(const std::vector<std::size_t>& motions,
                                                             double needed) const {
  std::vector<Bounded> order;
  for (const std::size_t motion : motions) {
    order.push_back({unrefitted(motion), motion});
  }
  const auto byBound = [](const Bounded& a, const Bounded& b) { return a.most > b.most; };
  std::stable_sort(order.begin(), order.end(), byBound);
  std::map<std::string, std::size_t> of_kind;
  std::vector<std::pair<std::size_t, Bounded>> by_round;
  for (const Bounded& one : order) {
    by_round.emplace_back(of_kind[played_.motions()[one.motion]->kind]++, one);
  }
  std::stable_sort(by_round.begin(), by_round.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Bounded> chosen;
  for (const auto& [round, one] : by_round) {
    if (chosen.size() < kRefitted && one.most >= needed) {
      chosen.push_back(one);
    }
  }
  std::stable_sort(chosen.begin(), chosen.end(), byBound);
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

bool Discriminator::addsUp(std::size_t explanation) const {
  return explanations_[explanation].fitted->hypothesis.isAdditive() && fitter_.forces().isAdditive();
}

// Whether the force of a term is the same beside all others.
bool Discriminator::isPlayedAlone(std::size_t explanation, Eigen::Index term) const {
  const fit::Hypothesis& hypothesis = explanations_[explanation].fitted->hypothesis;
  return hypothesis.terms[static_cast<std::size_t>(term)].on_rig || addsUp(explanation);
}

// As in fits, terms at nothing whose force would have to be simulated beside the others stay there.
bool Discriminator::isMovable(std::size_t explanation, Eigen::Index term) const {
  return explanations_[explanation].fitted->fit.parameters.scales[term] != 0.0 || isPlayedAlone(explanation, term);
}

std::vector<bool> Discriminator::movable(std::size_t explanation) const {
  const Eigen::Index terms = explanations_[explanation].fitted->fit.parameters.scales.size();
  std::vector<bool> movable;
  for (Eigen::Index t = 0; t < terms; ++t) {
    movable.push_back(isMovable(explanation, t));
  }
  return movable;
}

// Moves one parameter; terms that add up with all else are played alone, and so is then the model.
Discriminator::Derivative Discriminator::derivativeBy(std::size_t explanation, Eigen::Index unknown) const {
  const fit::Hypothesis& hypothesis = explanations_[explanation].fitted->hypothesis;
  fit::ParameterVector moved = explanations_[explanation].fitted->fit.parameters;
  const Eigen::Index of_model = moved.model.size();
  if (unknown < of_model) {
    const bool alone = addsUp(explanation);
    if (alone) {
      moved.scales.setZero();
    }
    const double at = moved.model[unknown];
    double step = kModelStep;
    moved.model[unknown] = at + step;
    std::vector<element::ElementDescription> elements = elementsOf(explanation, moved);
    if (elements.empty()) {
      step = -step;
      moved.model[unknown] = at + step;
      elements = elementsOf(explanation, moved);
    }
    return {std::move(elements), step, alone ? Base::model_alone : Base::whole};
  }
  const Eigen::Index t = unknown - of_model;
  const fit::BasisTerm& term = hypothesis.terms[static_cast<std::size_t>(t)];
  if (!isMovable(explanation, t)) {
    return {};
  }
  if (isPlayedAlone(explanation, t)) {
    return {{term.at(term.typical)}, term.typical, Base::nothing};
  }
  const double step = (moved.scales[t] + term.typical > term.upper ? -kTermStep : kTermStep) * term.typical;
  moved.scales[t] += step;
  return {elementsOf(explanation, moved), step, Base::whole};
}

// On each of the motions played, by difference quotients, without what is free in a new log. `whole`: its forces there.
std::vector<Eigen::MatrixXd> Discriminator::derivatives(std::size_t explanation,
                                                        const std::vector<Eigen::VectorXd>& whole) const {
  const hypotheses::FittedHypothesis& fitted = *explanations_[explanation].fitted;
  const fit::ParameterVector& at = fitted.fit.parameters;
  const std::vector<Eigen::VectorXd> of_model =
      addsUp(explanation) ? played_.forces(elementsOf(explanation, {at.model, 0.0 * at.scales}))
                          : std::vector<Eigen::VectorXd>();
  const auto count = static_cast<std::size_t>(at.model.size() + at.scales.size());
  std::vector<Eigen::MatrixXd> columns;
  for (const Eigen::VectorXd& force : whole) {
    columns.emplace_back(Eigen::MatrixXd::Zero(force.size(), static_cast<Eigen::Index>(count)));
  }
  fit::parallelFor(count, threads_, [&](std::size_t unknown) {
    const auto j = static_cast<Eigen::Index>(unknown);
    const Derivative by = derivativeBy(explanation, j);
    if (by.elements.empty()) {  // no model on either side, or a term that stays: it cannot move
      return;
    }
    const std::vector<Eigen::VectorXd> moved = played_.forces(by.elements);
    for (std::size_t m = 0; m < moved.size(); ++m) {
      columns[m].col(j) = moved[m] / by.step;
      if (by.base != Base::nothing) {
        columns[m].col(j) -= (by.base == Base::whole ? whole : of_model)[m] / by.step;
      }
    }
  });
  for (std::size_t m = 0; m < whole.size(); ++m) {
    columns[m] = withoutFree(std::move(columns[m]), fitted.hypothesis.free_in_log, whole[m]);
  }
  return columns;
}

// What an explanation, were it wrong, would be fitted to: the columns themselves are too many to be kept.
void Discriminator::project(std::size_t wrong, const std::vector<std::size_t>& motions) {
  Says& said = says_[wrong];
  std::vector<Eigen::VectorXd> whole;
  for (const std::size_t motion : motions) {
    whole.push_back(said.force[motion]);
  }
  const std::vector<Eigen::MatrixXd> columns = derivatives(wrong, whole);
  for (std::size_t m = 0; m < motions.size(); ++m) {
    OnMotion& on_motion = said.on_motion[motions[m]];
    on_motion.gram = numerics::gramOf(columns[m]);
    for (const Says& right : says_) {
      const Eigen::VectorXd difference = withoutFree(right.force[motions[m]] - whole[m], normal_[wrong].free, whole[m]);
      on_motion.moment.emplace_back(columns[m].transpose() * difference);
      on_motion.square.push_back(difference.squaredNorm());
    }
  }
}

// RMS force by which the wrong explanation is off, wherever it puts that: on the motion, or on the logs before [N].
double Discriminator::leftAfterRefit(std::size_t right, std::size_t wrong, std::size_t motion) const {
  const Normal& normal = normal_[wrong];
  const OnMotion& on_motion = says_[wrong].on_motion[motion];
  const Eigen::VectorXd& force = says_[right].force[motion];
  const auto logs = static_cast<double>(fitter_.records().size());
  // Relative to the force of the new log, which weighs as much as each of the others.
  const double variance = std::pow(gap::standardDeviation(force), 2);
  const double unit = 1.0 / (variance * static_cast<double>(force.size()));
  const Eigen::Index count = on_motion.gram.cols();
  Eigen::MatrixXd gram = logs * normal.gram;
  gram.topLeftCorner(count, count) += unit * on_motion.gram;
  Eigen::VectorXd moment = Eigen::VectorXd::Zero(gram.rows());
  moment.head(count) = unit * on_motion.moment[right];
  const Eigen::VectorXd step = numerics::boundedLeastSquares(gram, moment, normal.bounds.lower, normal.bounds.upper);
  const double square = unit * on_motion.square[right];
  const double cost = square - 2.0 * step.dot(moment) + step.dot(gram * step);
  return std::sqrt(variance * std::clamp(cost, 0.0, square));
}

Discrimination Discriminator::weigh(const Experiment& experiment, std::size_t motion) const {
  const auto logs = static_cast<double>(fitter_.records().size());
  Discrimination result;
  result.experiment = &experiment;
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

Discrimination Discriminator::best(const std::vector<Experiment>& menu, double needed) {
  const auto play = [&](const std::vector<std::size_t>& places) {
    std::vector<const Experiment*> motions;
    for (const std::size_t place : places) {
      motions.push_back(&menu[place]);
    }
    played_.play(std::move(motions));
  };
  std::vector<std::size_t> all(menu.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  play(all);
  sayForces();
  const std::vector<Bounded> chosen = promising(playable(), needed);
  if (normal_.empty() && !chosen.empty()) {
    findNormalEquations();
  }
  Discrimination best;
  std::size_t next = 0;
  const auto mayTellMore = [&] {
    return next < chosen.size() && (best.experiment == nullptr || chosen[next].most > best.floors);
  };
  while (mayTellMore()) {
    std::vector<std::size_t> some;
    while (mayTellMore() && some.size() < kAtOnce) {
      some.push_back(chosen[next++].motion);
    }
    play(some);
    for (std::size_t e = 0; e < explanations_.size(); ++e) {
      project(e, some);
    }
    for (const std::size_t motion : some) {
      const Discrimination here = weigh(menu[motion], motion);
      best = best.experiment == nullptr || here.floors > best.floors ? here : best;
    }
  }
  return best;
}

}  // namespace rubber_suspension::diagnosis::experiment
