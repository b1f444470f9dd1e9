// The verdict: thresholds, probabilities, sets that cannot be told apart.
#include "rubber_suspension/diagnosis/verdict.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "rubber_suspension/diagnosis/excess.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr double kNeedsAnother = 0.55;  // one more effect has to reduce the excess below this part
constexpr double kContributes = 0.67;   // an effect without which this part would be more than is left does show
constexpr double kUnknown = 0.33;       // a gap closed by less than this is not explained
constexpr double kPartly = 0.7;         // closed by less than this: explained in part
constexpr double kWorthNaming = 0.15;   // or else by this part of the gap
constexpr double kHalf = 0.5;           // of the gap: what a last resort may leave at most
constexpr double kMuchLess = 0.67;      // of what all others leave: what a last resort has to stay below
// Probabilities over the excess: sharpness, and the blur within which nothing can be told apart, as parts of the noise
// floor and of the gap. Fitted by maximum likelihood to cases of virtual rigs that take part in no trial.
constexpr double kSharpness = 3.0;
constexpr double kNoiseBlur = 0.2;
constexpr double kGapBlur = 0.015;
constexpr double kSetProbability = 0.9;

class Decision {
 public:
  Decision(const Search& search, std::size_t most_effects, bool trends)
      : search_(search), most_effects_(most_effects), trends_(trends) {
    verdict_.model = search.re_estimated;
    verdict_.probabilities.assign(search.candidates.size(), 0.0);
    base_ = excess(search.re_estimated);
  }

  Verdict decide() {
    rank();
    if (rubber_suspension::diagnosis::excess(search_, search_.configured_gap) < insignificant(search_)) {
      verdict_.kind = VerdictKind::none;
      verdict_.model = configuredTrial();
    } else if (closedByOwnParameters(search_)) {
      const Trial* hidden = most_effects_ > 0 ? hiddenEffect(search_) : nullptr;
      verdict_.kind = VerdictKind::parameter_error;
      if (hidden != nullptr) {
        name(*hidden);
      }
    } else {
      name();
      considerLastResort();
    }
    return std::move(verdict_);
  }

 private:
  double excess(const Trial& trial) const { return rubber_suspension::diagnosis::excess(search_, trial); }

  bool allowed(const Trial& trial) const {
    return (trends_ || !hasTrends(search_.candidates, trial.members)) &&
           (last_resort_ || !hasLastResort(search_.candidates, trial.members));
  }

  // Effects that these logs would hardly show are not to be named, unless the others leave much without them.
  bool testable(const Trial& trial) const {
    return std::all_of(trial.members.begin(), trial.members.end(), [&](int member) {
      return shows(search_, member) ||
             (trial.members.size() > 1 && excess(trial) < kContributes * without(trial, member));
    });
  }

  Trial configuredTrial() const {
    Trial trial = search_.re_estimated;
    trial.fit.point.own.setZero();
    return trial;
  }

  // Probability of each candidate from what it leaves against what its absence leaves: a power of the ratio, softened
  // by the noise, within which nothing can be told apart, less that of a candidate that changes nothing. The last entry
  // is that of none of them, of weight `none`.
  std::vector<double> probabilities(const std::vector<double>& excesses, double absent, double none) const {
    const double blur = std::pow(kNoiseBlur * search_.noise + kGapBlur * base_, 2);
    std::vector<double> weights;
    for (const double x : excesses) {
      const double ratio = (absent * absent + blur) / (x * x + blur);
      weights.push_back(std::isfinite(x) ? std::max(0.0, std::pow(ratio, kSharpness) - 1.0) : 0.0);
    }
    weights.push_back(none);
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (double& weight : weights) {
      weight = sum > 0.0 ? weight / sum : 0.0;
    }
    return weights;
  }

  void rank() {
    std::vector<double> excesses;
    for (const Trial& trial : search_.singles) {
      excesses.push_back(allowed(trial) ? excess(trial) : std::numeric_limits<double>::infinity());
    }
    const std::vector<double> weights = probabilities(excesses, base_, 1.0);
    std::copy(weights.begin(), weights.end() - 1, verdict_.probabilities.begin());
    verdict_.probability_none_of_these = weights.back();
  }

  const Trial* best(const std::vector<Trial>& trials) const {
    const Trial* found = nullptr;
    for (const Trial& trial : trials) {
      if (allowed(trial) && testable(trial) && (found == nullptr || excess(trial) < excess(*found))) {
        found = &trial;
      }
    }
    return found;
  }

  void name() {
    if (most_effects_ == 0) {
      verdict_.kind = VerdictKind::unknown;
      return;
    }
    const Trial* chosen = bestSingle(search_, trends_);
    if (chosen == nullptr) {
      verdict_.kind = VerdictKind::unknown;
      return;
    }
    for (const auto* more : {&search_.pairs, &search_.triples}) {
      const Trial* trial = chosen->members.size() < most_effects_ ? best(*more) : nullptr;
      if (trial == nullptr || (excess(*chosen) < enough(search_) && !hasTrends(search_.candidates, chosen->members))) {
        continue;
      }
      const double ratio = excess(*trial) / excess(*chosen);
      if (ratio < kNeedsAnother || excess(*chosen) - excess(*trial) > kWorthNaming * base_) {
        chosen = trial;
      }
    }
    if (1.0 - excess(*chosen) / base_ < kUnknown) {
      verdict_.kind = VerdictKind::unknown;
      return;
    }
    name(*chosen);
  }

  void name(const Trial& chosen) {
    verdict_.model = chosen;
    orderEffects(chosen);
    findSets(chosen);
    const double closed = 1.0 - excess(chosen) / base_;
    const bool rest = excess(chosen) > enough(search_) && closed < kPartly;
    const bool ambiguous = std::any_of(verdict_.confounded.begin(), verdict_.confounded.end(),
                                       [](const std::vector<int>& set) { return set.size() > 1; });
    verdict_.kind = rest ? VerdictKind::partly : ambiguous ? VerdictKind::confounded : VerdictKind::named;
  }

  // The least that any of the others leave.
  double leastOfOthers() const {
    double least = base_;
    for (const auto* trials : {&search_.singles, &search_.pairs, &search_.triples}) {
      for (const Trial& trial : *trials) {
        least = allowed(trial) ? std::min(least, excess(trial)) : least;
      }
    }
    return least;
  }

  // An effect that can look like several others stands where it leaves half of the gap at most, and all others leave
  // much more.
  void considerLastResort() {
    if (most_effects_ == 0 || (verdict_.kind != VerdictKind::unknown && verdict_.kind != VerdictKind::partly)) {
      return;
    }
    const double others = leastOfOthers();
    for (const Trial& trial : search_.singles) {
      const double left = excess(trial);
      if (hasLastResort(search_.candidates, trial.members) && shows(search_, trial.members.front()) &&
          left < kHalf * base_ && left < kMuchLess * others) {
        last_resort_ = true;
        rank();
        verdict_.confounded.clear();
        name(trial);
      }
    }
  }

  const Trial* find(std::vector<int> members) const {
    std::sort(members.begin(), members.end());
    for (const auto* trials : {&search_.singles, &search_.pairs, &search_.triples}) {
      for (const Trial& trial : *trials) {
        if (trial.members == members) {
          return &trial;
        }
      }
    }
    return nullptr;
  }

  // What the excess would be without one of the effects; infinite where that was not worth a fit.
  double without(const Trial& trial, int effect) const {
    std::vector<int> others;
    std::copy_if(trial.members.begin(), trial.members.end(), std::back_inserter(others),
                 [&](int member) { return member != effect; });
    const Trial* rest = others.empty() ? &search_.re_estimated : find(others);
    return rest != nullptr ? excess(*rest) : std::numeric_limits<double>::infinity();
  }

  // Most important is the effect whose absence leaves most.
  void orderEffects(const Trial& trial) {
    verdict_.effects = trial.members;
    std::stable_sort(verdict_.effects.begin(), verdict_.effects.end(),
                     [&](int a, int b) { return without(trial, a) > without(trial, b); });
  }

  // For each effect: which others in its place would explain the logs as well.
  void findSets(const Trial& trial) {
    for (const int effect : verdict_.effects) {
      std::vector<double> excesses;
      for (int c = 0; c < static_cast<int>(search_.candidates.size()); ++c) {
        std::vector<int> members = trial.members;
        std::replace(members.begin(), members.end(), effect, c);
        const bool twice =
            c != effect && std::find(trial.members.begin(), trial.members.end(), c) != trial.members.end();
        const Trial* other = twice ? nullptr : find(members);
        const bool counts = other != nullptr && allowed(*other);
        excesses.push_back(counts ? excess(*other) : std::numeric_limits<double>::infinity());
      }
      const double absent = std::min(without(trial, effect), base_);
      std::vector<double> weights = probabilities(excesses, absent, 0.0);
      weights.pop_back();
      if (trial.members.size() > 1) {  // in company, an effect is as sure as its place is
        verdict_.probabilities[static_cast<std::size_t>(effect)] = weights[static_cast<std::size_t>(effect)];
      }
      verdict_.confounded.push_back(smallestSet(weights));
    }
  }

  static std::vector<int> smallestSet(const std::vector<double>& weights) {
    std::vector<int> order(weights.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
      return weights[static_cast<std::size_t>(a)] > weights[static_cast<std::size_t>(b)];
    });
    std::vector<int> set;
    double sum = 0.0;
    for (const int candidate : order) {
      if (sum >= kSetProbability) {
        break;
      }
      set.push_back(candidate);
      sum += weights[static_cast<std::size_t>(candidate)];
    }
    return set;
  }

  const Search& search_;
  std::size_t most_effects_;
  bool trends_;
  bool last_resort_ = false;
  Verdict verdict_;
  double base_ = 0.0;
};

}  // namespace

std::string toString(VerdictKind kind) {
  static const char* const names[] = {"none", "parameter_error", "named", "confounded", "unknown", "partly"};
  return names[static_cast<int>(kind)];
}

Verdict decide(const Search& search, std::size_t most_effects, bool trends) {
  return Decision(search, most_effects, trends).decide();
}

}  // namespace rubber_suspension::diagnosis
