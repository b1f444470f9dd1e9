// Weighing of hypotheses.
#include "diagnosis/judge/weighing.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <iterator>
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
  return std::max(hypothesis.at_least, std::hypot(left(hypothesis.held_out), hypothesis.penalty));
}

double Weighing::insignificant() const {
  return std::max(
      {criteria_.within_noise * evidence_.noise_floor, criteria_.insignificant_gap, evidence_.discretisation});
}

double Weighing::tolerated() const {
  return closedByParameters() ? std::max(insignificant(), left(evidence_.reEstimated())) : insignificant();
}

std::optional<int> Weighing::bestOf(const std::function<bool(const HypothesisEvidence& single)>& counts) const {
  std::optional<int> best;
  for (int effect = 0; effect < evidence_.effects(); ++effect) {
    const HypothesisEvidence& single = evidence_.single(effect);
    if (counts(single) && (!best || left(single) < left(evidence_.at(*best)))) {
      best = Evidence::kFirstSingle + effect;
    }
  }
  return best;
}

std::optional<int> Weighing::bestSingle() const {
  return bestOf([this](const HypothesisEvidence& single) { return !single.last_resort && mayBeACause(single); });
}

bool Weighing::closedByParameters() const {
  const double configured = left(evidence_.at(Evidence::kAsConfigured).held_out);
  const double rest = left(evidence_.reEstimated().held_out);
  const bool by_elements =
      left(evidence_.element_level) < insignificant() && rest < criteria_.share_left_before_elements * configured;
  return rest < insignificant() || by_elements;
}

bool Weighing::mayBeACause(const HypothesisEvidence& hypothesis) const {
  if (hypothesis.like_parameters || gainsAreHistory(hypothesis)) {
    return false;
  }
  if (!hypothesis.free_trends) {
    return true;
  }
  return explainedByTrends(hypothesis) > evidence_.slow_noise;
}

bool Weighing::gainsAreHistory(const HypothesisEvidence& hypothesis) const {
  if (!hypothesis.free_gains || !hypothesis.history) {
    return false;
  }
  std::vector<int> others;
  std::copy_if(hypothesis.members.begin(), hypothesis.members.end(), std::back_inserter(others),
               [this](int member) { return !evidence_.single(member).free_gains; });
  const std::optional<int> without = evidence_.find(others);
  const double most = criteria_.needs_another * criteria_.needs_another;
  return without && left(hypothesis.held_out) > most * left(evidence_.at(*without).held_out);
}

double Weighing::explainedByTrends(const HypothesisEvidence& hypothesis) const {
  double without = evidence_.reEstimated().held_out;
  std::vector<int> others;
  std::vector<int> simpler;  // in the place of trends
  for (const int member : hypothesis.members) {
    if (!evidence_.single(member).free_trends) {
      without = std::min(without, evidence_.single(member).held_out);
      others.push_back(member);
    } else {
      const std::vector<int> contained = evidence_.containedIn(member);
      simpler.insert(simpler.end(), contained.begin(), contained.end());
    }
  }
  simpler.insert(simpler.end(), others.begin(), others.end());
  for (const std::vector<int>& members : {others, simpler}) {
    const std::optional<int> fitted = evidence_.find(members);
    without = fitted ? std::min(without, evidence_.at(*fitted).held_out) : without;
  }
  return gap::residualAboveFloor(without, hypothesis.held_out);
}

double Weighing::slowNoise() const {
  double most = 0.0;
  for (int effect = 0; effect < evidence_.effects(); ++effect) {
    const HypothesisEvidence& single = evidence_.single(effect);
    if (single.free_trends && !mayBeACause(single)) {
      most = std::max(most, explainedByTrends(single));
    }
  }
  return most;
}

double Weighing::leftUnseen(const UnseenErrors& errors) {
  return gap::residualAboveFloor(errors.gap, errors.noise_floor);
}

bool Weighing::isBeyondNoise(const UnseenErrors& errors) const {
  return isBeyondNoise(leftUnseen(errors), errors.noise_floor);
}

bool Weighing::isBeyondNoise(const HypothesisEvidence& hypothesis) const {
  return isBeyondNoise(residualOf(hypothesis), evidence_.noise_floor) ||
         (hypothesis.unseen && isBeyondNoise(*hypothesis.unseen));
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

bool Weighing::errsLess(const HypothesisEvidence& hypothesis, const HypothesisEvidence& over) const {
  const PairedDifference gain = difference(hypothesis, over);
  return -gain.mean > std::max(gain.standard_error, std::log1p(criteria_.clearly_less));
}

// Of three tests, any of which is enough: on average over the logs, by Student's t and by signs, and in two logs by
// their blocks. Over few logs the first sees nothing where some gain far more than the others, which logs do that were
// made to show it.
double Weighing::chanceOfGain(const HypothesisEvidence& hypothesis, const HypothesisEvidence& over) const {
  if (!knowsBlocks(hypothesis, over)) {
    return 0.0;
  }
  const double on_average = difference(hypothesis, over).pValueOfNoGain();
  if (!logsAreClusters()) {
    return on_average;
  }
  const Losses losses = lossesOf(hypothesis, over);
  return std::min(1.0, 3.0 * std::min({on_average, pValueBySigns(losses, 0, 1), pValueOfTwoLogs(losses, 0, 1)}));
}

double Weighing::residualOf(const HypothesisEvidence& hypothesis) const {
  return std::max(hypothesis.at_least, left(hypothesis.held_out));
}

bool Weighing::gainsEnough(const HypothesisEvidence& hypothesis, const HypothesisEvidence& over) const {
  return left(hypothesis) < left(over) && residualOf(hypothesis) < criteria_.needs_another * residualOf(over);
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

std::optional<int> Weighing::simplerThanParameters() const {
  const double far = std::log1p(criteria_.values_err_by);
  if (evidence_.reEstimated().largest_change <= far) {
    return std::nullopt;
  }
  return bestOf([&](const HypothesisEvidence& single) {
    const bool simple = !single.like_parameters && single.terms <= criteria_.few_terms && !single.free_trends &&
                        single.largest_change <= far;
    return simple && left(single) < criteria_.needs_another * left(evidence_.reEstimated());
  });
}

std::optional<int> Weighing::betterUnseen() const {
  const std::optional<UnseenErrors>& parameters = evidence_.reEstimated().unseen;
  const std::optional<int> best = bestSingle();
  const std::optional<UnseenErrors> effect = best ? evidence_.at(*best).unseen : std::nullopt;
  const bool better = parameters && effect && isBeyondNoise(*parameters) &&
                      leftUnseen(*effect) < criteria_.needs_another * leftUnseen(*parameters);
  return better ? best : std::nullopt;
}

bool needsFurtherEffects(const Evidence& evidence, const Criteria& criteria) {
  const Weighing weighing(evidence, criteria);
  if (weighing.closedByParameters()) {
    return false;
  }
  const std::optional<int> single = weighing.bestSingle();
  // A trend follows whatever is slow: it may stand for two effects that are.
  return !single || weighing.left(evidence.at(*single)) > weighing.insignificant() || evidence.at(*single).free_trends;
}

}  // namespace rubber_suspension::diagnosis
