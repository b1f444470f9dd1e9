// The judgement: what the logs of the fit speak for, confirmed or not by logs that took no part in it.
#include "diagnosis/judge/judge.h"

#include <algorithm>
#include <set>

#include "diagnosis/judge/families.h"
#include "diagnosis/judge/further_logs.h"
#include "diagnosis/judge/naming.h"
#include "diagnosis/judge/posterior.h"
#include "diagnosis/judge/rest_as_noise.h"
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
    if (evidence_.has_unseen_logs) {
      sayWhatRemainsOfUnseenLogs();
    }
    acceptLittle();
    noteTestableEffects();
    weighAnswers();
    considerWhatDoesAsValuesDo();
    return std::move(judgement_);
  }

 private:
  // The next best hypothesis, until what is named holds on data that took no part in the fit.
  void nameWhatHolds() {
    std::set<int> refuted;
    while (true) {
      judgement_ = nameEffects(evidence_, criteria_, refuted);
      if (judgement_.effects.empty() || holds()) {
        return;
      }
      refuted.insert(judgement_.model);
    }
  }

  // True if what is named closes part of the gap for sure; also where wrong values would do as well and only few
  // numbers moved far speak against them, which is said.
  bool holds() {
    if (!eachCloses() || closesNextToNothingUnseen()) {
      return false;
    }
    if (weighing_.closesForSure(evidence_.at(judgement_.model), evidence_.reEstimated())) {
      return true;
    }
    if (judgement_.verdict == Verdict::partly || !valuesWouldDo() || doesWorseUnseen()) {
      return false;
    }
    judgement_.verdict = Verdict::confounded;
    judgement_.values_would_do = true;
    return true;
  }

  // What does not explain a gap of the logs of the fit does not explain one of unseen logs.
  bool closesNextToNothingUnseen() const {
    if (!evidence_.has_unseen_logs || !weighing_.isBeyondNoise(unseen(Evidence::kReEstimated))) {
      return false;
    }
    const double gap = Weighing::leftUnseen(unseen(Evidence::kReEstimated));
    return 1.0 - Weighing::leftUnseen(unseen(judgement_.model)) / gap < criteria_.unknown;
  }

  // Of several effects, each closes part of what the others leave of unseen logs, where these show that they leave
  // anything: what an unseen log does not excite it says nothing of.
  bool eachCloses() {
    if (!evidence_.has_unseen_logs || judgement_.effects.size() < 2) {
      return true;
    }
    for (const int effect : judgement_.effects) {
      const std::optional<int> others = evidence_.without(judgement_.model, effect);
      if (!others) {
        continue;
      }
      const bool shown = !showsNothing(unseen(*others)) || weighing_.isBeyondNoise(unseen(judgement_.model));
      if (shown && !weighing_.closesForSure(evidence_.at(judgement_.model), evidence_.at(*others))) {
        return false;
      }
    }
    return true;
  }

  // What re-estimated parameters leave is accepted, and what is named leaves more of unseen logs.
  bool doesWorseUnseen() const {
    return evidence_.has_unseen_logs &&
           !weighing_.isBeyondNoise(weighing_.residualOf(evidence_.reEstimated()), evidence_.noise_floor) &&
           unseen(judgement_.model).gap > criteria_.floor_margin * unseen(Evidence::kReEstimated).gap;
  }

  // Re-estimated parameters leave next to nothing, here or on unseen logs.
  bool valuesWouldDo() const {
    return weighing_.closedByParameters() ||
           (evidence_.has_unseen_logs &&
            unseen(Evidence::kReEstimated).gap < criteria_.shows_nothing * unseen(judgement_.model).noise_floor);
  }

  // What a hypothesis leaves of unseen logs is no more than their noise.
  bool showsNothing(const UnseenErrors& errors) const {
    return errors.gap < criteria_.shows_nothing * errors.noise_floor;
  }

  bool unseenLogsRefuteValues() const {
    const std::optional<UnseenErrors>& values = evidence_.reEstimated().unseen;
    return values && weighing_.isBeyondNoise(*values);
  }

  const UnseenErrors& unseen(int hypothesis) const { return *evidence_.at(hypothesis).unseen; }

  // A rest that no effect explains is not worth a warning where an engineer accepts it on all logs: a model without
  // effects, or with other values where these gain as much as an effect would have to.
  void acceptLittle() {
    const double configured = weighing_.left(evidence_.at(Evidence::kAsConfigured).held_out);
    const double rest = weighing_.left(evidence_.reEstimated().held_out);
    if (judgement_.verdict != Verdict::unknown || rest > criteria_.beyond_noise) {
      return;
    }
    if (evidence_.has_unseen_logs && Weighing::leftUnseen(unseen(Evidence::kReEstimated)) > criteria_.beyond_noise) {
      return;
    }
    const bool parameters = rest < criteria_.needs_another * configured || configured > criteria_.beyond_noise;
    judgement_.withdraw(parameters ? Verdict::parameter_error : Verdict::none,
                        parameters ? Evidence::kReEstimated : Evidence::kAsConfigured);
  }

  // A rest beyond the noise is told; one that the logs of the fit do not show is something that only these lack.
  void sayWhatRemainsOfUnseenLogs() {
    if (judgement_.verdict == Verdict::unknown || judgement_.verdict == Verdict::partly) {
      return;
    }
    if (weighing_.isBeyondNoise(unseen(judgement_.model))) {
      judgement_.verdict = judgement_.effects.empty() ? Verdict::unknown : Verdict::partly;
    }
  }

  void noteTestableEffects() {
    const std::vector<int>& named = judgement_.effects;
    for (int effect = 0; effect < evidence_.effects(); ++effect) {
      judgement_.testable.push_back(evidence_.testable[static_cast<std::size_t>(effect)] ||
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
      if (!evidence_.has_unseen_logs || !weighing_.isBeyondNoise(unseen(hypothesis))) {
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

// The logs of the fit alone show no gap, or one that values close.
bool agrees(const Evidence& evidence, const Criteria& criteria) {
  const Weighing weighing(evidence, criteria);
  return evidence.has_unseen_logs &&
         (weighing.left(evidence.at(Evidence::kAsConfigured).held_out) < weighing.insignificant() ||
          weighing.closedByParameters());
}

Judgement judgeOnce(const Evidence& evidence, const Criteria& criteria) {
  Evidence settled = withFurtherLogs(evidence);
  settleFamilies(settled, criteria);
  Judgement judgement = Judge(settled, criteria).run();
  judgement.only_unseen_logs_differ = judgement.verdict == Verdict::unknown && agrees(evidence, criteria);
  return judgement;
}

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
  Judgement judgement = judgeOnce(evidence, criteria);
  if (judgement.verdict == Verdict::unknown && motionCausesSmallerPart(evidence, criteria)) {
    Judgement of_the_rest = judgeOnce(withRestAsNoise(evidence, criteria), criteria);
    if (!of_the_rest.effects.empty() && !evidence.at(of_the_rest.model).sensor &&
        closesBeyondNoise(evidence, criteria, of_the_rest.model)) {
      of_the_rest.verdict = Verdict::partly;
      return of_the_rest;
    }
  }
  return judgement;
}

}  // namespace rubber_suspension::diagnosis
