// The judgement: what the logs of the fit speak for, confirmed or not by logs that took no part in it.
#include "diagnosis/judge/judge.h"

#include <algorithm>
#include <initializer_list>

#include "diagnosis/judge/families.h"
#include "diagnosis/judge/naming.h"
#include "diagnosis/judge/posterior.h"
#include "diagnosis/judge/weighing.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {
namespace {

class Judge {
 public:
  Judge(const Evidence& evidence, const Criteria& criteria)
      : evidence_(evidence), criteria_(criteria), weighing_(evidence, criteria) {}

  Judgement run() {
    nameWhatHolds();
    if (evidence_.has_unseen_logs && !judgement_.missing) {
      treatUnconfirmedResidualAsNoise();
      if (!judgement_.missing) {
        sayWhatRemainsOfUnseenLogs();
      }
    }
    if (!judgement_.missing) {
      acceptLittle();
    }
    noteTestableEffects();
    weighAnswers();
    if (!judgement_.missing) {
      considerWhatDoesAsValuesDo();
    }
    return std::move(judgement_);
  }

 private:
  // Fewer effects, until those that are named hold on data that took no part in the fit.
  void nameWhatHolds() {
    for (std::size_t most = criteria_.most_effects;; --most) {
      judgement_ = nameEffects(evidence_, criteria_, most);
      if (judgement_.effects.empty()) {
        return;
      }
      if (evidence_.has_unseen_logs) {
        preferWhatPredictsUnseenLogs(most);
      }
      if (judgement_.missing || (evidence_.has_unseen_logs && lacks({Evidence::kReEstimated, judgement_.model})) ||
          holds()) {
        return;
      }
      most = std::min(most, judgement_.effects.size());  // fewer than the false positives
    }
  }

  // True if what is named closes part of the gap for sure; also where wrong values would do as well and only few
  // numbers moved far speak against them, which is said.
  bool holds() {
    if (evidence_.has_unseen_logs && !holdsOnUnseenLogs()) {
      return false;
    }
    if (!eachCloses() || judgement_.missing) {
      return judgement_.missing.has_value();
    }
    if (weighing_.closesForSure(evidence_.at(judgement_.model), evidence_.reEstimated())) {
      return true;
    }
    if (judgement_.verdict == Verdict::partly || !valuesWouldDo()) {
      return false;
    }
    judgement_.verdict = Verdict::confounded;
    judgement_.values_would_do = true;
    return true;
  }

  // Of several effects, each closes part of what the others leave of unseen logs.
  bool eachCloses() {
    if (!evidence_.has_unseen_logs || judgement_.effects.size() < 2) {
      return true;
    }
    for (const int effect : judgement_.effects) {
      const std::optional<int> others = evidence_.without(judgement_.model, effect);
      if (!others) {
        continue;
      }
      if (lacks({*others})) {
        return true;
      }
      if (!weighing_.closesForSure(evidence_.at(judgement_.model), evidence_.at(*others))) {
        return false;
      }
    }
    return true;
  }

  // Re-estimated parameters leave next to nothing, here or on unseen logs.
  bool valuesWouldDo() const {
    return weighing_.closedByParameters() ||
           (evidence_.has_unseen_logs && unseenLogsShowNothing(unseen(judgement_.model).noise_floor));
  }

  bool unseenLogsRefuteValues() const {
    const std::optional<UnseenErrors>& values = evidence_.reEstimated().unseen;
    return values && weighing_.isBeyondNoise(*values);
  }

  bool unseenLogsShowNothing(double floor) const {
    return unseen(Evidence::kReEstimated).predicted < criteria_.shows_nothing * floor;
  }

  // True, and noted, where errors of one of these hypotheses are needed and not known.
  bool lacks(std::initializer_list<int> hypotheses) {
    const auto* unknown =
        std::find_if(hypotheses.begin(), hypotheses.end(), [&](int h) { return !evidence_.at(h).unseen; });
    if (unknown != hypotheses.end()) {
      judgement_.missing = *unknown;
    }
    return unknown != hypotheses.end();
  }

  const UnseenErrors& unseen(int hypothesis) const { return *evidence_.at(hypothesis).unseen; }

  void preferWhatPredictsUnseenLogs(std::size_t most) {
    if (!evidence_.at(judgement_.model).free_trends) {
      return;
    }
    const Judgement other = nameEffects(evidence_, criteria_, most, false);
    if (other.effects.empty() || lacks({Evidence::kReEstimated, judgement_.model, other.model})) {
      return;
    }
    const double before = unseen(Evidence::kReEstimated).predicted;
    const double after = unseen(other.model).predicted;
    if (after < (1.0 - criteria_.predicts) * before &&
        after < unseen(judgement_.model).predicted - criteria_.predicts_clearly_more * before) {
      judgement_ = other;
    }
  }

  // The prediction is from the displacement smoothed as for the fits: a mass or a dashpot may be there, and yet make
  // more noise of a sensor's noise than it explains.
  bool holdsOnUnseenLogs() const {
    const double before = unseen(Evidence::kReEstimated).predicted;
    const double after = unseen(judgement_.model).predicted;
    const double floor = unseen(judgement_.model).noise_floor;
    if (unseenLogsShowNothing(floor)) {
      return true;
    }
    const double closed = gap::closedFraction(before, after, floor);
    if (weighing_.closedByParameters() && !weighing_.hiddenEffect()) {
      return closed >= 1.0 - criteria_.needs_another;  // as much as on the logs of the fit
    }
    return closed >= criteria_.least_closed_unseen || ((isDriftAlone() || weighing_.closedByParameters()) &&
                                                       after < criteria_.little_lost_unseen * before + floor);
  }

  bool isDriftAlone() const { return judgement_.effects.size() == 1 && evidence_.at(judgement_.model).free_trends; }

  // What the component of a hypothesis leaves of unseen logs above their floor, which is that of the model judged.
  double unseenLeft(int hypothesis) const {
    return gap::residualAboveFloor(unseen(hypothesis).replayed, unseen(judgement_.model).noise_floor);
  }

  void treatUnconfirmedResidualAsNoise() {
    const bool unexplained =
        judgement_.verdict == Verdict::unknown || (judgement_.verdict == Verdict::partly && isDriftAlone());
    if (!unexplained ||
        weighing_.left(evidence_.reEstimated().held_out) > criteria_.unconfirmed_is_noise * evidence_.noise_floor) {
      return;
    }
    if (lacks({Evidence::kAsConfigured, Evidence::kReEstimated, judgement_.model})) {
      return;
    }
    if (unseenLeft(Evidence::kAsConfigured) < weighing_.insignificant()) {
      judgement_.withdraw(Verdict::none, Evidence::kAsConfigured);
    } else if (unseenLeft(Evidence::kReEstimated) < weighing_.insignificant()) {
      judgement_.withdraw(Verdict::parameter_error, Evidence::kReEstimated);
    }
  }

  // A rest that no effect explains and an engineer accepts, on all logs, is not worth a warning.
  void acceptLittle() {
    if (judgement_.verdict != Verdict::unknown ||
        weighing_.left(evidence_.reEstimated().held_out) > criteria_.beyond_noise) {
      return;
    }
    if (evidence_.has_unseen_logs && (lacks({Evidence::kAsConfigured, Evidence::kReEstimated}) ||
                                      Weighing::leftUnseen(unseen(Evidence::kReEstimated)) > criteria_.beyond_noise)) {
      return;
    }
    const double configured = weighing_.left(evidence_.at(Evidence::kAsConfigured).held_out);
    const double rest = weighing_.left(evidence_.reEstimated().held_out);
    const bool parameters = configured > criteria_.beyond_noise || rest < criteria_.needs_another * configured;
    judgement_.withdraw(parameters ? Verdict::parameter_error : Verdict::none,
                        parameters ? Evidence::kReEstimated : Evidence::kAsConfigured);
  }

  // A rest beyond the noise is told; one that the logs of the fit do not show is something that only these lack.
  void sayWhatRemainsOfUnseenLogs() {
    if (judgement_.verdict == Verdict::unknown || judgement_.verdict == Verdict::partly || isDriftAlone() ||
        lacks({judgement_.model})) {
      return;
    }
    if (weighing_.isBeyondNoise(unseen(judgement_.model))) {
      const std::optional<int> best = weighing_.bestSingle();
      if (judgement_.verdict == Verdict::parameter_error && best && lacks({*best})) {
        return;  // it may be better than the values
      }
      judgement_.only_unseen_logs_differ = judgement_.effects.empty();
      judgement_.verdict = judgement_.effects.empty() ? Verdict::unknown : Verdict::partly;
    }
  }

  void noteTestableEffects() {
    const std::vector<int>& named = judgement_.effects;
    for (int effect = 0; effect < evidence_.effects(); ++effect) {
      judgement_.testable.push_back(weighing_.shows(effect) ||
                                    std::find(named.begin(), named.end(), effect) != named.end());
    }
  }

  // An effect is as probable as that effects are at work at all, and this one among them. Wrong values are in the set
  // of what cannot be told apart by the same rule as effects are: without them it would not be as probable as it has
  // to.
  void weighAnswers() {
    judgement_.posterior = posterior(evidence_, criteria_, judgement_);
    const Posterior& answers = judgement_.posterior;
    const bool fully = judgement_.verdict == Verdict::named || judgement_.verdict == Verdict::confounded;
    if (fully && !unseenLogsRefuteValues() &&
        answers.effects < criteria_.set_probability * (answers.effects + answers.parameter_error)) {
      judgement_.verdict = Verdict::confounded;
      judgement_.values_would_do = true;
    }
    for (double& probability : judgement_.probabilities) {
      probability *= judgement_.posterior.effects;
    }
  }

  // Values that are all off by one factor, or a sensor that is: no log tells them apart, so both are as probable.
  void considerWhatDoesAsValuesDo() {
    if (judgement_.verdict != Verdict::parameter_error) {
      return;
    }
    const double enough = std::max(weighing_.insignificant(), weighing_.left(evidence_.reEstimated().held_out));
    for (int effect = 0; effect < evidence_.effects(); ++effect) {
      const HypothesisEvidence& single = evidence_.single(effect);
      if (!single.like_parameters || single.within_tolerance || single.largest_change >= criteria_.changed_little ||
          weighing_.left(single.held_out) > enough) {
        continue;
      }
      const int hypothesis = Evidence::kFirstSingle + effect;
      if (!evidence_.has_unseen_logs || (!lacks({hypothesis}) && !weighing_.isBeyondNoise(unseen(hypothesis)))) {
        nameBesideValues(effect);
      }
      return;
    }
  }

  void nameBesideValues(int effect) {
    judgement_.verdict = Verdict::confounded;
    judgement_.model = Evidence::kFirstSingle + effect;
    judgement_.effects = {effect};
    judgement_.confounded = {{effect}};
    judgement_.values_would_do = true;
    judgement_.testable[static_cast<std::size_t>(effect)] = true;
    judgement_.posterior = sharedWithValues(judgement_.posterior);
    judgement_.probabilities.assign(judgement_.probabilities.size(), 0.0);
    judgement_.probabilities[static_cast<std::size_t>(effect)] = judgement_.posterior.effects;
  }

  const Evidence& evidence_;
  const Criteria& criteria_;
  Weighing weighing_;
  Judgement judgement_;
};

}  // namespace

std::string toString(Verdict verdict) {
  static const char* const names[] = {"none",    "parameter_error", "named",      "confounded",
                                      "unknown", "partly",          "check_bench"};
  return names[static_cast<int>(verdict)];
}

void Judgement::withdraw(Verdict without_effects, int without_model) {
  verdict = without_effects;
  model = without_model;
  effects.clear();
  confounded.clear();
}

Judgement judge(const Evidence& evidence, const Criteria& criteria) {
  Evidence settled = evidence;
  settleFamilies(settled, criteria);
  return Judge(settled, criteria).run();
}

}  // namespace rubber_suspension::diagnosis
