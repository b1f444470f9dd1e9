// The verdict on the logs of the fit: which effects are named, probabilities, sets that cannot be told apart.
#include "diagnosis/judge/naming.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "diagnosis/judge/weighing.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Naming {
 public:
  Naming(const Evidence& evidence, const Criteria& criteria, const std::set<int>& refuted)
      : evidence_(evidence),
        criteria_(criteria),
        weighing_(evidence, criteria),
        refuted_(refuted),
        gap_(left(Evidence::kReEstimated)) {
    judgement_.probabilities.assign(evidence.testable.size(), 0.0);
  }

  Judgement run() {
    rank(Of::those_in_question);
    if (weighing_.left(evidence_.at(Evidence::kAsConfigured).held_out) < weighing_.insignificant()) {
      judgement_.verdict = Verdict::none;
      judgement_.model = Evidence::kAsConfigured;
    } else if (weighing_.closedByParameters()) {
      const std::optional<int> simpler = weighing_.simplerThanParameters();
      const std::optional<int> effect = simpler ? simpler : weighing_.betterUnseen();
      judgement_.verdict = Verdict::parameter_error;
      if (effect && refuted_.count(*effect) == 0) {
        name(*effect);
      }
    } else {
      nameBest();
      if (judgement_.verdict == Verdict::unknown) {
        considerSlowNoise();
      }
    }
    if (judgement_.effects.empty()) {
      rank(Of::all);
    }
    return std::move(judgement_);
  }

 private:
  double left(int hypothesis) const { return weighing_.left(evidence_.at(hypothesis)); }

  int hypotheses() const { return static_cast<int>(evidence_.hypotheses.size()); }

  bool considered(int hypothesis) const { return weighing_.mayBeACause(evidence_.at(hypothesis)); }

  // What can look like several others is out of question where these do as well, however many they are.
  bool allowed(int hypothesis) const {
    const HypothesisEvidence& h = evidence_.at(hypothesis);
    return considered(hypothesis) && refuted_.count(hypothesis) == 0 && !(h.last_resort && h.does_no_better);
  }

  // A law that contains a simpler one and errs no less is not in question: the simpler one stands for both.
  bool inQuestion(int hypothesis) const { return allowed(hypothesis) && !evidence_.at(hypothesis).does_no_better; }

  // Probability of each effect from what it leaves against what its absence leaves: a power of the ratio, softened
  // by the noise, within which nothing can be told apart, less that of an effect that changes nothing.
  std::vector<double> shares(const std::vector<double>& rests, double absent) const {
    const double blur = std::pow(criteria_.noise_blur * evidence_.noise_floor + criteria_.gap_blur * gap_, 2);
    std::vector<double> weights;
    for (const double rest : rests) {
      const double ratio = (absent * absent + blur) / (rest * rest + blur);
      weights.push_back(std::isfinite(rest) ? std::max(0.0, std::pow(ratio, criteria_.sharpness) - 1.0) : 0.0);
    }
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (double& weight : weights) {
      weight = sum > 0.0 ? weight / sum : 0.0;
    }
    return weights;
  }

  enum class Of { those_in_question, all };

  // Where nothing is named, what was refuted is as likely as the logs of the fit have it, if effects are at work at
  // all.
  void rank(Of of) {
    std::vector<double> rests;
    for (int effect = 0; effect < evidence_.effects(); ++effect) {
      const int single = Evidence::kFirstSingle + effect;
      const bool counts = of == Of::all ? considered(single) : inQuestion(single);
      rests.push_back(counts ? left(single) : kInfinity);
    }
    judgement_.probabilities = shares(rests, gap_);
  }

  // The best hypothesis of so many effects.
  std::optional<int> best(std::size_t effects) const {
    std::optional<int> found;
    for (int h = 0; h < hypotheses(); ++h) {
      if (evidence_.at(h).members.size() == effects && allowed(h) && (!found || left(h) < left(*found))) {
        found = h;
      }
    }
    return found;
  }

  // Beside gains of each log, which may do nearly as well by themselves and stand back for a simpler law all the same,
  // any other effect has to gain as one more effect has to.
  bool needsOthersThanGains(int hypothesis) const {
    const HypothesisEvidence& all = evidence_.at(hypothesis);
    return !all.free_gains || std::all_of(all.members.begin(), all.members.end(), [&](int effect) {
      const std::optional<int> others = evidence_.without(hypothesis, effect);
      return evidence_.single(effect).free_gains || !others ||
             weighing_.left(all.held_out) < criteria_.needs_another * weighing_.left(evidence_.at(*others).held_out);
    });
  }

  // Closes the larger part of what fewer effects leave, and as much of the gap as an explanation has to: more than the
  // form of a law that is not quite the right one leaves.
  bool explainsAsMuch(int further, int fewer) const {
    const HypothesisEvidence& more = evidence_.at(further);
    const double rest = weighing_.residualOf(evidence_.at(fewer));
    const double closed = gap::residualAboveFloor(rest, weighing_.residualOf(more));
    return !more.free_gains && left(further) < left(fewer) &&
           weighing_.residualOf(more) <= (1.0 - criteria_.unknown) * rest &&
           closed > criteria_.unknown * weighing_.residualOf(evidence_.reEstimated()) &&
           weighing_.isBeyondNoise(closed, evidence_.noise_floor);
  }

  // From a single effect to the best hypothesis of more, as long as each further effect gains enough beyond chance:
  // over the best hypothesis of fewer effects, even where that gained too little itself.
  int withFurtherEffects(int single) const {
    int chosen = single;
    int fewer = single;
    for (std::size_t effects = 2; effects <= criteria_.most_effects; ++effects) {
      const std::optional<int> further = best(effects);
      // Nothing is sought in a rest that counts as explained.
      if (!further || !(weighing_.isBeyondNoise(evidence_.at(chosen)) || evidence_.at(chosen).free_trends)) {
        break;
      }
      const bool enough =
          weighing_.gainsEnough(evidence_.at(*further), evidence_.at(fewer)) || explainsAsMuch(*further, fewer);
      if (needsOthersThanGains(*further) && enough &&
          weighing_.chanceOfGain(evidence_.at(*further), evidence_.at(fewer)) < criteria_.chance) {
        chosen = *further;
      }
      fewer = left(*further) < left(fewer) ? *further : fewer;
    }
    return chosen;
  }

  // Other values leave no more than counts as explained, and gained what an effect would have to.
  bool valuesLeaveLittle() const {
    return !weighing_.isBeyondNoise(evidence_.reEstimated()) &&
           weighing_.residualOf(evidence_.reEstimated()) <
               criteria_.needs_another * weighing_.residualOf(evidence_.at(Evidence::kAsConfigured));
  }

  void nameBest() {
    judgement_.verdict = Verdict::unknown;
    const std::optional<int> single = best(1);
    if (!single) {
      return;
    }
    const int chosen = withFurtherEffects(*single);
    const double most = valuesLeaveLittle() ? criteria_.needs_another : 1.0 - criteria_.unknown;
    if (left(chosen) <= most * gap_) {
      name(chosen);
    }
  }

  void name(int chosen) {
    judgement_.model = chosen;
    orderEffects(chosen);
    findSets(chosen);
    // What is left of the force: what moved parameters cost weighs on the choice, not on this.
    const double rest_left = weighing_.left(evidence_.at(chosen).held_out);
    const double closed = 1.0 - rest_left / weighing_.left(evidence_.reEstimated().held_out);
    const bool rest = (rest_left > weighing_.insignificant() && closed < criteria_.partly) ||
                      weighing_.isBeyondNoise(rest_left, evidence_.noise_floor);
    const bool ambiguous = std::any_of(judgement_.confounded.begin(), judgement_.confounded.end(),
                                       [](const std::vector<int>& set) { return set.size() > 1; });
    judgement_.verdict = rest ? Verdict::partly : ambiguous ? Verdict::confounded : Verdict::named;
  }

  // Where nothing but slow noise remains, there is no gap, or parameters close it.
  void considerSlowNoise() {
    const double slow = weighing_.slowNoise();
    const auto rest = [&](int hypothesis) {
      return weighing_.left(gap::residualAboveFloor(evidence_.at(hypothesis).held_out, slow));
    };
    if (slow > 0.0 && rest(Evidence::kReEstimated) < weighing_.insignificant()) {
      const bool configured = rest(Evidence::kAsConfigured) < weighing_.insignificant();
      judgement_.withdraw(configured ? Verdict::none : Verdict::parameter_error,
                          configured ? Evidence::kAsConfigured : Evidence::kReEstimated);
    }
  }

  // What would be left without one of the effects; infinite where that was not worth a fit.
  double leftWithout(int hypothesis, int effect) const {
    const std::optional<int> rest = evidence_.without(hypothesis, effect);
    return rest ? left(*rest) : kInfinity;
  }

  // Most important is the effect whose absence leaves most.
  void orderEffects(int hypothesis) {
    judgement_.effects = evidence_.at(hypothesis).members;
    std::stable_sort(judgement_.effects.begin(), judgement_.effects.end(),
                     [&](int a, int b) { return leftWithout(hypothesis, a) > leftWithout(hypothesis, b); });
  }

  // What each effect would leave in the place of one of the effects named; infinite where that was not fitted.
  std::vector<double> leftInPlaceOf(int effect, int hypothesis) const {
    std::vector<double> rests;
    for (int other = 0; other < evidence_.effects(); ++other) {
      const std::optional<int> found = evidence_.inPlaceOf(hypothesis, effect, other);
      const bool counts = found && (*found == hypothesis || inQuestion(*found));
      rests.push_back(counts ? left(*found) : kInfinity);
    }
    return rests;
  }

  // For each effect: which others in its place would explain the logs as well.
  void findSets(int hypothesis) {
    const std::vector<int>& members = evidence_.at(hypothesis).members;
    for (const int effect : judgement_.effects) {
      const double absent = std::min(leftWithout(hypothesis, effect), gap_);
      const std::vector<double> weights = shares(leftInPlaceOf(effect, hypothesis), absent);
      if (members.size() > 1) {  // beside others, an effect is as sure as its place is
        judgement_.probabilities[static_cast<std::size_t>(effect)] = weights[static_cast<std::size_t>(effect)];
      }
      judgement_.confounded.push_back(smallestSet(weights));
    }
  }

  std::vector<int> smallestSet(const std::vector<double>& weights) const {
    std::vector<int> order(weights.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
      return weights[static_cast<std::size_t>(a)] > weights[static_cast<std::size_t>(b)];
    });
    std::vector<int> set;
    double sum = 0.0;
    for (const int effect : order) {
      if (sum >= criteria_.set_probability) {
        break;
      }
      set.push_back(effect);
      sum += weights[static_cast<std::size_t>(effect)];
    }
    return set;
  }

  const Evidence& evidence_;
  const Criteria& criteria_;
  Weighing weighing_;
  const std::set<int>& refuted_;
  double gap_;  // left by re-estimation
  Judgement judgement_;
};

}  // namespace

Judgement nameEffects(const Evidence& evidence, const Criteria& criteria, const std::set<int>& refuted) {
  return Naming(evidence, criteria, refuted).run();
}

}  // namespace rubber_suspension::diagnosis
