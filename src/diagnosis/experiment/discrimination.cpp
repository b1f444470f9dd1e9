// Refits explanations to motions and compares the results.
#include "diagnosis/experiment/discrimination.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "diagnosis/judge/numbers.h"
#include "element/each.h"
#include "fit/parallel.h"
#include "numerics/bounded_least_squares.h"
#include "numerics/gram.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis::experiment {
namespace {

constexpr std::size_t kRefitted = 8;   // largest number of motions to which explanations are refitted
constexpr std::size_t kAtOnce = 2;     // number of these motions that are simulated at the same time
constexpr double kLeastSquare = 1e-8;  // smallest mean square, so that logarithms are finite

void withoutDirection(const Eigen::VectorXd& direction, Eigen::MatrixXd& columns) {
  const double square = direction.squaredNorm();
  if (square > 0.0) {
    columns -= direction / square * (direction.transpose() * columns).eval();
  }
}

// Eliminates the offset of a new log, a ramp if trends are free, and a multiple of the force if gains are free.
Eigen::MatrixXd withoutFree(Eigen::MatrixXd columns, const fit::PerLogNuisances& free, const Eigen::VectorXd& force) {
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
      candidates_(search.candidates),
      noise_(search.noise.floor),
      force_(search.excitation.force),
      force_limit_(force_limit),
      threads_(threads),
      played_(fitter.records()),
      forces_([this](const auto& elements) { return played_.forces(elements); }, fitter.model()) {}

void Discriminator::predictForces() {
  predictions_.assign(explanations_.size(), {});
  fit::parallelFor(predictions_.size(), threads_, [&](std::size_t e) {
    const hypotheses::FittedHypothesis& fitted = *explanations_[e].fitted;
    predictions_[e].force = played_.forces(*fit::elementsOf(fitter_.model(), fitted.hypothesis, fitted.fit.parameters));
    predictions_[e].on_motion.resize(predictions_[e].force.size());
  });
}

std::vector<std::size_t> Discriminator::playable() const {
  std::vector<std::size_t> motions;
  for (std::size_t m = 0; m < played_.motions().size(); ++m) {
    const bool within = std::all_of(predictions_.begin(), predictions_.end(), [&](const Predictions& predictions) {
      return predictions.force[m].allFinite() && predictions.force[m].cwiseAbs().maxCoeff() <= force_limit_;
    });
    if (within) {
      motions.push_back(m);
    }
  }
  return motions;
}

// Returns the additional squared noise of a new log with this force, divided by the variance of this force.
double Discriminator::moreNoise(const Eigen::VectorXd& force) const {
  const double ratio = force_ / gap::standardDeviation(force);
  return std::pow(judge::fittedNumbers().floor_known * noise_, 2) * std::max(0.0, ratio * ratio - 1.0);
}

// Returns the expected entropy without a refit of the explanations, by which motions are sorted.
double Discriminator::unrefitted(std::size_t motion) const {
  const auto logs = static_cast<double>(fitter_.records().size());
  double open = 0.0;
  for (std::size_t right = 0; right < predictions_.size(); ++right) {
    const Eigen::VectorXd& force = predictions_[right].force[motion];
    std::vector<Refitted> refitted;
    for (const Predictions& wrong : predictions_) {
      const double off = gap::standardDeviation(force - wrong.force[motion]) / gap::standardDeviation(force);
      refitted.push_back({off * off, 0.0});
    }
    open += explanations_[right].probability * outlookOf(right, explanations_, refitted, moreNoise(force), logs).open;
  }
  return open;
}

// Returns the motions with the least expected entropy, one of each kind in each round, because a refit absorbs the
// differences on all motions of one kind by the same parameters.
std::vector<std::size_t> Discriminator::promising(const std::vector<std::size_t>& motions) const {
  std::vector<std::pair<double, std::size_t>> order(motions.size());
  fit::parallelFor(motions.size(), threads_, [&](std::size_t i) { order[i] = {unrefitted(motions[i]), motions[i]}; });
  std::stable_sort(order.begin(), order.end());
  std::map<std::string, std::size_t> of_kind;
  std::vector<std::pair<std::size_t, std::size_t>> by_round;
  for (const auto& [open, motion] : order) {
    by_round.emplace_back(of_kind[played_.motions()[motion]->kind]++, motion);
  }
  std::stable_sort(by_round.begin(), by_round.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < std::min(kRefitted, by_round.size()); ++i) {
    chosen.push_back(by_round[i].second);
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

bool Discriminator::addsUp(std::size_t explanation) const {
  return explanations_[explanation].fitted->hypothesis.isAdditive() && fitter_.forces().isAdditive();
}

// Returns true if the force of a term does not depend on the other terms.
bool Discriminator::isPlayedAlone(std::size_t explanation, Eigen::Index term) const {
  const fit::Hypothesis& hypothesis = explanations_[explanation].fitted->hypothesis;
  return hypothesis.terms[static_cast<std::size_t>(term)].on_rig || addsUp(explanation);
}

// Returns true for the terms that a refit may change. A term at 0 stays there if it cannot be simulated alone.
std::vector<bool> Discriminator::movable(std::size_t explanation) const {
  const Eigen::VectorXd& scales = explanations_[explanation].fitted->fit.parameters.scales;
  std::vector<bool> movable;
  for (Eigen::Index t = 0; t < scales.size(); ++t) {
    movable.push_back(scales[t] != 0.0 || isPlayedAlone(explanation, t));
  }
  return movable;
}

// Returns an explanation with the forces on the motions of those terms that can be simulated alone.
fit::Hypothesis Discriminator::played(std::size_t explanation) const {
  fit::Hypothesis hypothesis = explanations_[explanation].fitted->hypothesis;
  fit::parallelFor(hypothesis.terms.size(), threads_, [&](std::size_t t) {
    fit::BasisTerm& term = hypothesis.terms[t];
    term.unit_effect = nullptr;
    if (isPlayedAlone(explanation, static_cast<Eigen::Index>(t))) {
      gap::Forces forces = played_.forces({term.at(term.typical)});
      std::for_each(forces.begin(), forces.end(), [&](Eigen::VectorXd& force) { force /= term.typical; });
      term.unit_effect = fit::columnOf(forces);
    }
  });
  return hypothesis;
}

// Returns the derivatives of the force with respect to the parameters on each motion that is played, after elimination
// of the free parameters of a new log. `whole` contains the forces of the explanation on these motions.
std::vector<Eigen::MatrixXd> Discriminator::derivatives(std::size_t explanation,
                                                        const std::vector<Eigen::VectorXd>& whole) const {
  const fit::Hypothesis hypothesis = played(explanation);
  const std::vector<fit::ForceColumn> columns = forces_.columns(
      hypothesis, explanations_[explanation].fitted->fit.parameters, movable(explanation), whole, threads_);
  std::vector<Eigen::MatrixXd> derivatives;
  for (std::size_t m = 0; m < whole.size(); ++m) {
    Eigen::MatrixXd of_motion = Eigen::MatrixXd::Zero(whole[m].size(), static_cast<Eigen::Index>(columns.size()));
    for (std::size_t j = 0; j < columns.size(); ++j) {
      if (columns[j]) {
        of_motion.col(static_cast<Eigen::Index>(j)) = (*columns[j])[m];
      }
    }
    derivatives.push_back(withoutFree(std::move(of_motion), hypothesis.free_in_log, whole[m]));
  }
  return derivatives;
}

// Stores the products that a refit of a wrong explanation needs, because the derivatives would need too much memory.
void Discriminator::project(std::size_t wrong, const std::vector<std::size_t>& motions) {
  Predictions& of_wrong = predictions_[wrong];
  const auto whole = element::each(motions, [&](std::size_t motion) { return of_wrong.force[motion]; });
  const std::vector<Eigen::MatrixXd> columns = derivatives(wrong, whole);
  for (std::size_t m = 0; m < motions.size(); ++m) {
    OnMotion& on_motion = of_wrong.on_motion[motions[m]];
    on_motion.gram = numerics::gramOf(columns[m]);
    for (const Predictions& right : predictions_) {
      const Eigen::VectorXd difference = withoutFree(right.force[motions[m]] - whole[m], normal_[wrong].free, whole[m]);
      on_motion.moment.emplace_back(columns[m].transpose() * difference);
      on_motion.square.push_back(difference.squaredNorm());
    }
  }
}

// Returns the log prior of the sizes of the effects, from the normalised products of the forces of their terms.
double Discriminator::priorOfSizes(std::size_t explanation, const Eigen::MatrixXd& gram,
                                   const Eigen::VectorXd& scales) const {
  std::vector<double> sizes;
  Eigen::Index first = 0;
  for (const std::size_t count : explanations_[explanation].fitted->hypothesis.counts) {
    const auto terms = static_cast<Eigen::Index>(count);
    const Eigen::VectorXd of_member = scales.segment(first, terms);
    const double square = of_member.dot(gram.block(first, first, terms, terms) * of_member);
    sizes.push_back(0.5 * std::log(std::max(square, kLeastSquare)));
    first += terms;
  }
  return judge::priorOfSizes(sizes, explanations_[explanation].usual_size, judge::fittedNumbers().share_spread);
}

// Returns the error of a wrong explanation after a refit to the motion and the logs, and the change of its prior.
Refitted Discriminator::refitted(std::size_t right, std::size_t wrong, std::size_t motion) const {
  const Normal& normal = normal_[wrong];
  const OnMotion& on_motion = predictions_[wrong].on_motion[motion];
  const Eigen::VectorXd& force = predictions_[right].force[motion];
  const auto logs = static_cast<double>(fitter_.records().size());
  // Errors are relative to the force of the new log, which has the same weight as each earlier log.
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
  const fit::ParameterVector& at = explanations_[wrong].fitted->fit.parameters;
  const Eigen::Index of_model = at.model.size();
  const Eigen::Index terms = at.scales.size();
  const auto ofTerms = [&](const Eigen::MatrixXd& all) { return all.block(of_model, of_model, terms, terms).eval(); };
  return {std::clamp(cost, 0.0, square),
          priorOfSizes(wrong, ofTerms(gram) / (logs + 1.0), at.scales + step.segment(of_model, terms)) -
              priorOfSizes(wrong, ofTerms(normal.gram), at.scales)};
}

Discrimination Discriminator::weigh(const Experiment& experiment, std::size_t motion) const {
  const auto logs = static_cast<double>(fitter_.records().size());
  Discrimination result;
  result.experiment = &experiment;
  result.open = 0.0;
  for (std::size_t right = 0; right < explanations_.size(); ++right) {
    std::vector<Refitted> all;
    for (std::size_t wrong = 0; wrong < explanations_.size(); ++wrong) {
      all.push_back(refitted(right, wrong, motion));
    }
    const Outlook outlook = outlookOf(right, explanations_, all, moreNoise(predictions_[right].force[motion]), logs);
    result.open += explanations_[right].probability * outlook.open;
    result.probability += explanations_[right].probability * outlook.alone;
    if (right == 0) {
      setNearest(all, result);
      result.difference *= gap::standardDeviation(predictions_[0].force[motion]);
    }
  }
  // A further log lowers the weight of each earlier log. If a motion would raise the entropy, its log can be omitted.
  result.open = std::min(result.open, openNames(explanations_, probabilitiesOf(explanations_)));
  return result;
}

void Discriminator::setNearest(const std::vector<Refitted>& refitted, Discrimination& result) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t e = 1; e < explanations_.size(); ++e) {
    const bool follows = fit::holds(candidates_, explanations_[e].fitted->hypothesis.members,
                                    explanations_[0].fitted->hypothesis.members);
    if (!follows && refitted[e].left < least) {
      least = refitted[e].left;
      result.nearest = e;
      result.difference = std::sqrt(least);
    }
  }
}

Discrimination Discriminator::best(const std::vector<Experiment>& menu) {
  const auto play = [&](const std::vector<std::size_t>& places) {
    played_.play(element::each(places, [&](std::size_t place) { return &menu[place]; }));
  };
  std::vector<std::size_t> all(menu.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  play(all);
  predictForces();
  const std::vector<std::size_t> chosen = promising(playable());
  if (normal_.empty() && !chosen.empty()) {
    findNormalEquations();
  }
  Discrimination best;
  for (std::size_t next = 0; next < chosen.size(); next += kAtOnce) {
    const std::vector<std::size_t> some(
        chosen.begin() + static_cast<std::ptrdiff_t>(next),
        chosen.begin() + static_cast<std::ptrdiff_t>(std::min(next + kAtOnce, chosen.size())));
    play(some);
    for (std::size_t e = 0; e < explanations_.size(); ++e) {
      project(e, some);
    }
    for (const std::size_t motion : some) {
      const Discrimination here = weigh(menu[motion], motion);
      best = best.experiment == nullptr || here.open < best.open ? here : best;
    }
  }
  return best;
}

}  // namespace rubber_suspension::diagnosis::experiment
