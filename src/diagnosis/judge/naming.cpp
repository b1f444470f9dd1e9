// The verdict on the logs of the fit: which effects are named, probabilities, sets that cannot be told apart.
#include "diagnosis/judge/naming.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "diagnosis/judge/weighing.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Naming {
 public:
  Naming(const Evidence& evidence, const Criteria& criteria, std::size_t most_effects, bool trends)
      : evidence_(evidence),
        criteria_(criteria),
        weighing_(evidence, criteria),
        most_effects_(most_effects),
        trends_(trends),
        gap_(left(Evidence::kReEstimated)) {
    judgement_.probabilities.assign(evidence.testable.size(), 0.0);
  }

  Judgement run() {
    rank();
    if (weighing_.left(evidence_.at(Evidence::kAsConfigured).held_out) < weighing_.insignificant()) {
      judgement_.verdict = Verdict::none;
      judgement_.model = Evidence::kAsConfigured;
    } else if (weighing_.closedByParameters()) {
      const std::optional<int> hidden = weighing_.hiddenEffect();
      const std::optional<int> effect = hidden ? hidden : weighing_.betterThanParameters();
      judgement_.verdict = Verdict::parameter_error;
      if (most_effects_ > 0 && effect) {
        name(*effect);
      }
    } else {
      nameBest();
      considerLastResort();
      doubtSmallGains();
      if (judgement_.verdict == Verdict::unknown) {
        considerSlowNoise();
      }
    }
    return std::move(judgement_);
  }

 private:
  double left(int hypothesis) const { return weighing_.left(evidence_.at(hypothesis)); }

  int hypotheses() const { return static_cast<int>(evidence_.hypotheses.size()); }

  bool allowed(int hypothesis) const {
    const HypothesisEvidence& h = evidence_.at(hypothesis);
    return (trends_ || !h.free_trends) && (last_resort_ || !h.last_resort) && weighing_.mayBeACause(h);
  }

  // Effects that these logs would hardly show are not to be named, unless the others leave much without them.
  bool testable(int hypothesis) const {
    const std::vector<int>& members = evidence_.at(hypothesis).members;
    return std::all_of(members.begin(), members.end(), [&](int member) {
      return weighing_.shows(member) ||
             (members.size() > 1 && left(hypothesis) < criteria_.contributes * leftWithout(hypothesis, member));
    });
  }

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

  void rank() {
    std::vector<double> rests;
    for (int effect = 0; effect < evidence_.effects(); ++effect) {
      const int single = Evidence::kFirstSingle + effect;
      rests.push_back(allowed(single) ? left(single) : kInfinity);
    }
    judgement_.probabilities = shares(rests, gap_);
  }

  // The best hypothesis of so many effects.
  std::optional<int> best(std::size_t effects) const {
    std::optional<int> found;
    for (int h = 0; h < hypotheses(); ++h) {
      const bool counts = evidence_.at(h).members.size() == effects && allowed(h) && testable(h);
      if (counts && (!found || left(h) < left(*found))) {
        found = h;
      }
    }
    return found;
  }

  void nameBest() {
    judgement_.verdict = Verdict::unknown;
    const std::optional<int> single = weighing_.bestSingle(trends_);
    if (most_effects_ == 0 || !single) {
      return;
    }
    int chosen = *single;
    for (const std::size_t effects : {std::size_t{2}, std::size_t{3}}) {
      const bool more = evidence_.at(chosen).members.size() < most_effects_;
      const std::optional<int> further = more ? best(effects) : std::nullopt;
      if (!further || (left(chosen) < weighing_.enough() && !evidence_.at(chosen).free_trends)) {
        continue;
      }
      const double ratio = left(*further) / left(chosen);
      const bool much =
          ratio < criteria_.needs_another || left(chosen) - left(*further) > criteria_.worth_naming * gap_;
      if (much && weighing_.chanceOfGain(evidence_.at(*further), evidence_.at(chosen)) < criteria_.chance) {
        chosen = *further;
      }
    }
    if (1.0 - left(chosen) / gap_ >= criteria_.unknown) {
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
    const bool rest = (rest_left > weighing_.enough() && closed < criteria_.partly) ||
                      weighing_.isBeyondNoise(rest_left, evidence_.noise_floor);
    const bool ambiguous = std::any_of(judgement_.confounded.begin(), judgement_.confounded.end(),
                                       [](const std::vector<int>& set) { return set.size() > 1; });
    judgement_.verdict = rest ? Verdict::partly : ambiguous ? Verdict::confounded : Verdict::named;
  }

  // The least that any of the others leave.
  double leastOfOthers() const {
    double least = gap_;
    for (int h = Evidence::kFirstSingle; h < hypotheses(); ++h) {
      least = allowed(h) ? std::min(least, left(h)) : least;
    }
    return least;
  }

  // An effect that can look like several others stands where it leaves half of the gap at most, and all others leave
  // much more.
  void considerLastResort() {
    if (most_effects_ == 0 || (judgement_.verdict != Verdict::unknown && judgement_.verdict != Verdict::partly)) {
      return;
    }
    const double others = leastOfOthers();
    for (int effect = 0; effect < evidence_.effects(); ++effect) {
      const int single = Evidence::kFirstSingle + effect;
      if (evidence_.at(single).last_resort && weighing_.shows(effect) &&
          left(single) < criteria_.last_resort_left * gap_ && left(single) < criteria_.last_resort_of_others * others) {
        last_resort_ = true;
        rank();
        judgement_.confounded.clear();
        name(single);
      }
    }
  }

  // Where parameters leave little, an effect has to leave much less, beyond chance.
  void doubtSmallGains() {
    const double rest = weighing_.left(evidence_.reEstimated().held_out);
    const HypothesisEvidence& named = evidence_.at(judgement_.model);
    if (judgement_.effects.empty() || weighing_.isBeyondNoise(rest, evidence_.noise_floor) ||
        (weighing_.left(named.held_out) < criteria_.needs_another * rest &&
         weighing_.chanceOfGain(named, evidence_.reEstimated()) < criteria_.chance)) {
      return;
    }
    const double configured = weighing_.left(evidence_.at(Evidence::kAsConfigured).held_out);
    judgement_.withdraw(rest < criteria_.needs_another * configured ? Verdict::parameter_error : Verdict::unknown,
                        Evidence::kReEstimated);
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
      rests.push_back(found && allowed(*found) ? left(*found) : kInfinity);
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
  std::size_t most_effects_;
  bool trends_;
  bool last_resort_ = false;
  double gap_;  // left by re-estimation
  Judgement judgement_;
};

}  // namespace

Judgement nameEffects(const Evidence& evidence, const Criteria& criteria, std::size_t most_effects, bool trends) {
  return Naming(evidence, criteria, most_effects, trends).run();
}

}  // namespace rubber_suspension::diagnosis
