// Weighing of hypotheses.
#include "diagnosis/judge/weighing.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "diagnosis/judge/closed_interval.h"
#include "diagnosis/judge/paired_losses.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {

double Weighing::left(double error) const {
  return gap::residualAboveFloor(error, criteria_.floor_margin * evidence_.noise_floor);
}

double Weighing::left(const HypothesisEvidence& hypothesis) const {
  const double penalised = std::hypot(left(hypothesis.held_out), hypothesis.penalty);
  const double trend = criteria_.trend_penalty * left(evidence_.reEstimated().held_out);
  return std::max(hypothesis.at_least, hypothesis.free_trends ? std::hypot(penalised, trend) : penalised);
}

double Weighing::insignificant() const {
  return std::max({criteria_.within_noise * evidence_.noise_floor, criteria_.insignificant_gap,
                   criteria_.discretisation * evidence_.discretisation});
}

double Weighing::tolerated() const {
  const double configured = left(evidence_.at(Evidence::kAsConfigured).held_out);
  const double little = std::min(criteria_.above_noise_by_parameters * evidence_.noise_floor,
                                 criteria_.share_left_by_parameters * configured);
  const double rest = closedByParameters() ? left(evidence_.reEstimated().held_out) : 0.0;
  return std::max({insignificant(), little, rest});
}

double Weighing::enough() const {
  // However large the gap is: one large trivial effect, such as an offset, must not hide the rest.
  const double share = criteria_.share_of_gap_enough * left(evidence_.reEstimated());
  return std::max(criteria_.within_noise * evidence_.noise_floor,
                  std::min(share, criteria_.beyondNoise(evidence_.noise_floor)));
}

std::optional<int> Weighing::bestSingle(bool trends) const {
  std::optional<int> best;
  for (int effect = 0; effect < evidence_.effects(); ++effect) {
    const HypothesisEvidence& single = evidence_.single(effect);
    if ((!trends && single.free_trends) || single.last_resort || !mayBeACause(single)) {
      continue;
    }
    if (shows(effect) && (!best || left(single) < left(evidence_.at(*best)))) {
      best = Evidence::kFirstSingle + effect;
    }
  }
  return best;
}

bool Weighing::shows(int effect) const {
  return evidence_.testable[static_cast<std::size_t>(effect)] ||
         left(evidence_.single(effect)) < criteria_.shows * left(evidence_.reEstimated());
}

bool Weighing::closedByParameters() const {
  const double configured = left(evidence_.at(Evidence::kAsConfigured).held_out);
  const double rest = left(evidence_.reEstimated().held_out);
  if (rest < insignificant() || rest < std::min(criteria_.above_noise_by_parameters * evidence_.noise_floor,
                                                criteria_.share_left_by_parameters * configured)) {
    return true;
  }
  // Every element's own parameters: they explain the gap if they leave noise only, and if most of it was already
  // closed by the values of the specification.
  return left(evidence_.element_level) <
             std::max(criteria_.within_noise * evidence_.noise_floor, criteria_.share_left_by_elements * rest) &&
         rest < criteria_.share_left_before_elements * configured;
}

bool Weighing::mayBeACause(const HypothesisEvidence& hypothesis) const {
  if (hypothesis.like_parameters || !hypothesis.free_trends) {
    return !hypothesis.like_parameters;
  }
  double without = evidence_.reEstimated().held_out;
  for (const int member : hypothesis.members) {
    const HypothesisEvidence& single = evidence_.single(member);
    without = single.free_trends ? without : std::min(without, single.held_out);
  }
  return gap::residualAboveFloor(without, hypothesis.held_out) > evidence_.slow_noise;
}

double Weighing::slowNoise() const {
  double most = 0.0;
  for (int effect = 0; effect < evidence_.effects(); ++effect) {
    const HypothesisEvidence& single = evidence_.single(effect);
    if (single.free_trends && !mayBeACause(single)) {
      most = std::max(most, gap::residualAboveFloor(evidence_.reEstimated().held_out, single.held_out));
    }
  }
  return most;
}

double Weighing::leftUnseen(const UnseenErrors& errors) {
  return gap::residualAboveFloor(std::min(errors.replayed, errors.predicted), errors.noise_floor);
}

bool Weighing::isBeyondNoise(const UnseenErrors& errors) const {
  return isBeyondNoise(leftUnseen(errors), errors.noise_floor);
}

bool Weighing::knowsBlocks(const HypothesisEvidence& hypothesis, const HypothesisEvidence& over) const {
  return !over.block_errors.empty() && hypothesis.block_errors.size() == over.block_errors.size() &&
         over.block_errors.size() == evidence_.block_logs.size();
}

Losses Weighing::lossesOf(const HypothesisEvidence& hypothesis, const HypothesisEvidence& over) const {
  const auto blocks = static_cast<Eigen::Index>(over.block_errors.size());
  Eigen::MatrixXd errors(2, blocks);
  errors.row(0) = Eigen::Map<const Eigen::RowVectorXd>(hypothesis.block_errors.data(), blocks);
  errors.row(1) = Eigen::Map<const Eigen::RowVectorXd>(over.block_errors.data(), blocks);
  Losses losses;
  losses.loss = logarithmicLoss(errors, evidence_.noise_floor * evidence_.noise_floor);
  losses.weight = Eigen::Map<const Eigen::VectorXd>(evidence_.block_weights.data(), blocks);
  losses.cluster = evidence_.block_logs;
  return losses;
}

bool Weighing::logsAreClusters() const {
  constexpr std::size_t kFewestLogs = 3;
  return std::set<int>(evidence_.block_logs.begin(), evidence_.block_logs.end()).size() >= kFewestLogs;
}

PairedDifference Weighing::difference(const HypothesisEvidence& hypothesis, const HypothesisEvidence& over) const {
  if (!knowsBlocks(hypothesis, over)) {
    const double square = evidence_.noise_floor * evidence_.noise_floor;
    PairedDifference difference;
    difference.mean =
        0.5 * std::log((hypothesis.held_out * hypothesis.held_out + square) / (over.held_out * over.held_out + square));
    return difference;
  }
  Losses losses = lossesOf(hypothesis, over);
  if (!logsAreClusters()) {
    std::iota(losses.cluster.begin(), losses.cluster.end(), 0);
  }
  return compare(losses, 0, 1);
}

// Of two tests, either of which is enough: on average over the logs, and in every single log by its blocks. Over few
// logs the first sees nothing where one gains far more than the others, which a log does that was made to show it.
double Weighing::chanceOfGain(const HypothesisEvidence& hypothesis, const HypothesisEvidence& over) const {
  if (!knowsBlocks(hypothesis, over)) {
    return 0.0;
  }
  const double on_average = difference(hypothesis, over).pValueOfNoGain();
  return logsAreClusters()
             ? std::min(1.0, 2.0 * std::min(on_average, pValueOfSomeLog(lossesOf(hypothesis, over), 0, 1)))
             : on_average;
}

bool Weighing::closesForSure(const HypothesisEvidence& hypothesis, const HypothesisEvidence& over) const {
  const std::vector<gap::PartError> before = partsOf(over);
  const std::vector<gap::PartError> after = partsOf(hypothesis);
  if (before.empty() || before.size() != after.size()) {
    return true;
  }
  return closedInterval(before, after, evidence_.noise_floor, evidence_.resamplings, evidence_.seed)[0] > 0.0;
}

std::vector<gap::PartError> Weighing::partsOf(const HypothesisEvidence& hypothesis) const {
  if (evidence_.has_unseen_logs) {
    return hypothesis.unseen ? hypothesis.unseen->parts : std::vector<gap::PartError>{};
  }
  std::vector<gap::PartError> parts;
  for (std::size_t i = 0; i < std::min(hypothesis.block_errors.size(), evidence_.block_weights.size()); ++i) {
    parts.push_back({hypothesis.block_errors[i], evidence_.block_weights[i]});
  }
  return parts;
}

std::optional<int> Weighing::betterThanParameters() const {
  const HypothesisEvidence& parameters = evidence_.reEstimated();
  const double rest = left(parameters.held_out);
  const bool refuted =
      isBeyondNoise(rest, evidence_.noise_floor) || (parameters.unseen && isBeyondNoise(*parameters.unseen));
  const std::optional<int> best = bestSingle();
  if (!refuted || !best) {
    return std::nullopt;
  }
  const HypothesisEvidence& effect = evidence_.at(*best);
  const bool better_here = left(effect.held_out) < criteria_.needs_another * rest;
  const bool better_unseen = parameters.unseen && effect.unseen &&
                             leftUnseen(*effect.unseen) < criteria_.needs_another * leftUnseen(*parameters.unseen);
  return better_here || better_unseen ? best : std::nullopt;
}

std::optional<int> Weighing::hiddenEffect() const {
  const double re_estimated = left(evidence_.reEstimated());
  std::optional<int> best;
  if (evidence_.reEstimated().largest_change <= criteria_.changed_far) {
    return best;
  }
  for (int effect = 0; effect < evidence_.effects(); ++effect) {
    const HypothesisEvidence& single = evidence_.single(effect);
    const bool simple = !single.like_parameters && single.terms <= criteria_.few_terms && !single.free_trends;
    const double change = single.largest_change;
    const double may_leave = change < criteria_.changed_little ? criteria_.hides_as_specified
                             : change < criteria_.changed_far  ? criteria_.hides
                                                               : 0.0;
    const double rest = left(single);
    if (simple && rest < may_leave * re_estimated && (!best || rest < left(evidence_.at(*best)))) {
      best = Evidence::kFirstSingle + effect;
    }
  }
  return best;
}

bool needsFurtherEffects(const Evidence& evidence, const Criteria& criteria) {
  const Weighing weighing(evidence, criteria);
  if (weighing.closedByParameters()) {
    return false;
  }
  const std::optional<int> single = weighing.bestSingle();
  // A trend follows whatever is slow: it may stand for two effects that are.
  return !single || weighing.left(evidence.at(*single)) > weighing.enough() || evidence.at(*single).free_trends;
}

}  // namespace rubber_suspension::diagnosis
