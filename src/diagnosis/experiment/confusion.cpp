// The table of confusions.
#include "diagnosis/experiment/confusion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "diagnosis/judge/judge.h"
#include "diagnosis/judge/weighing.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr double kLeastSize = 1e-4;  // of the force, at which the search for the least size begins
constexpr int kHalvings = 10;        // of the logarithm between that and all of the force: to 1 %

enum class Outcome { found, confounded, taken_for, unexplained, out_of_reach };

const char* outcomeName(Outcome outcome) {
  static const char* const names[] = {"found", "confounded", "taken_for", "unexplained", "out_of_reach"};
  return names[static_cast<int>(outcome)];
}

HypothesisEvidence evidenceOf(const Leaves& leaves, double noise, double size) {
  HypothesisEvidence evidence;
  evidence.held_out = std::hypot(noise, size * leaves.gap);
  evidence.penalty = size * leaves.penalty;
  evidence.largest_change = size * leaves.change;
  return evidence;
}

Outcome outcomeOf(const Judgement& judgement, int effect) {
  if (judgement.effects.empty()) {
    return judgement.verdict == Verdict::unknown ? Outcome::unexplained : Outcome::out_of_reach;
  }
  for (std::size_t i = 0; i < judgement.effects.size(); ++i) {
    const std::vector<int>& set = judgement.confounded[i];
    if (std::find(set.begin(), set.end(), effect) != set.end()) {
      return set.size() == 1 && !judgement.values_would_do ? Outcome::found : Outcome::confounded;
    }
  }
  return Outcome::taken_for;
}

// The implants of one effect.
class EffectRow {
 public:
  EffectRow(const Search& search, const Criteria& criteria, int effect)
      : search_(search), criteria_(criteria), effect_(effect) {
    for (const Implant& implant : search.implants) {
      if (implant.effect == effect) {
        implants_.push_back(&implant);
      }
    }
  }

  ImplantedEffect at(double size) const {
    ImplantedEffect row;
    row.effect = name(effect_);
    row.named_as.assign(search_.candidates.size(), 0.0);
    if (implants_.empty()) {  // the logs lack what it needs
      row.outcome = outcomeName(Outcome::out_of_reach);
      row.nothing_named = 1.0;
      row.least_size = std::numeric_limits<double>::infinity();
      return row;
    }
    const double share = 1.0 / static_cast<double>(implants_.size());
    std::map<Outcome, double> outcomes;
    std::map<int, double> in_its_place;
    for (const Implant* implant : implants_) {
      row.visible_share = std::max(row.visible_share, implant->hidden_by_rig ? 0.0 : implant->model.gap);
      const Judgement judgement = judgementOf(*implant, size);
      outcomes[outcomeOf(judgement, effect_)] += share;
      (judgement.effects.empty() ? row.nothing_named
                                 : row.named_as[static_cast<std::size_t>(judgement.effects.front())]) += share;
      for (const int other : othersOf(judgement)) {
        in_its_place[other] += share;
      }
      if (judgement.values_would_do) {
        in_its_place[kWrongValues] += share;
      }
    }
    row.outcome = outcomeName(std::max_element(outcomes.begin(), outcomes.end(), [](const auto& a, const auto& b) {
                                return a.second < b.second;
                              })->first);
    row.taken_for = byShare(in_its_place);
    row.least_size = leastSize();
    return row;
  }

 private:
  static constexpr int kWrongValues = -1;  // in the place of an effect

  std::string name(int effect) const {
    return effect == kWrongValues ? toString(Verdict::parameter_error)
                                  : search_.candidates[static_cast<std::size_t>(effect)].effect;
  }

  // What values do as well takes nothing but their place.
  Judgement judgementOf(const Implant& implant, double size) const {
    if (implant.hidden_by_rig) {
      return {};
    }
    Judgement judgement = judge(diagnosis::evidenceOf(search_, implant, size), criteria_);
    const bool named = !judgement.effects.empty() && judgement.effects.front() != effect_;
    if (named && search_.candidates[static_cast<std::size_t>(judgement.effects.front())].like_parameters) {
      judgement.withdraw(Verdict::parameter_error, Evidence::kReEstimated);
    }
    return judgement;
  }

  // Named, or in the set of what is.
  std::vector<int> othersOf(const Judgement& judgement) const {
    std::vector<int> others;
    for (const std::vector<int>& set : judgement.confounded) {
      std::copy_if(set.begin(), set.end(), std::back_inserter(others), [&](int other) { return other != effect_; });
    }
    return others;
  }

  // Those of a fifth of the shapes at least, most first.
  std::vector<std::string> byShare(const std::map<int, double>& shares) const {
    constexpr double kToTell = 0.2;
    std::vector<std::pair<double, int>> order;
    for (const auto& [effect, share] : shares) {
      if (share > kToTell) {
        order.emplace_back(-share, effect);
      }
    }
    std::sort(order.begin(), order.end());
    std::vector<std::string> names;
    std::transform(order.begin(), order.end(), std::back_inserter(names),
                   [&](const auto& entry) { return name(entry.second); });
    return names;
  }

  bool halfIsFound(double size) const {
    std::size_t found = 0;
    for (const Implant* implant : implants_) {
      const Outcome outcome = outcomeOf(judgementOf(*implant, size), effect_);
      found += outcome == Outcome::found || outcome == Outcome::confounded ? 1 : 0;
    }
    return 2 * found >= implants_.size();
  }

  double leastSize() const {
    double low = std::log(kLeastSize);
    double high = 0.0;
    if (!halfIsFound(1.0)) {
      return std::numeric_limits<double>::infinity();
    }
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (low + high);
      (halfIsFound(std::exp(middle)) ? high : low) = middle;
    }
    return std::exp(high);
  }

  const Search& search_;
  const Criteria& criteria_;
  int effect_;
  std::vector<const Implant*> implants_;
};

}  // namespace

Evidence evidenceOf(const Search& search, const Implant& implant, double size) {
  Evidence evidence;
  evidence.noise_floor = search.noise;
  evidence.discretisation = search.discretisation;
  evidence.testable = search.testable;
  evidence.hypotheses.push_back(evidenceOf(Leaves{}, search.noise, size));
  evidence.hypotheses.push_back(evidenceOf(implant.model, search.noise, size));
  evidence.element_level = evidence.hypotheses.back().held_out;
  for (std::size_t c = 0; c < search.candidates.size(); ++c) {
    const fit::Candidate& candidate = search.candidates[c];
    HypothesisEvidence single = evidenceOf(implant.singles[c], search.noise, size);
    single.members = {static_cast<int>(c)};
    single.terms = candidate.terms.size();
    single.free_trends = candidate.free_in_log.trend;
    single.free_gains = candidate.free_in_log.gain;
    single.last_resort = candidate.last_resort;
    single.like_parameters = candidate.like_parameters;
    evidence.hypotheses.push_back(std::move(single));
  }
  return evidence;
}

CouldShow couldShow(const Search& search, double size, const std::string& why, const Criteria& criteria) {
  CouldShow table;
  table.size = size;
  table.force = size * search.excitation.force;
  table.why = why;
  table.noise = search.noise;
  for (std::size_t c = 0; c < search.candidates.size(); ++c) {
    table.effects.push_back(search.candidates[c].effect);
    table.implanted.push_back(EffectRow(search, criteria, static_cast<int>(c)).at(size));
  }
  return table;
}

CouldShow couldShow(const Search& search, const Criteria& criteria) {
  constexpr double kOfGap = 1.0 / 3.0;
  constexpr double kOfForce = 0.1;
  const double gap = gap::residualAboveFloor(search.configured_gap, criteria.floor_margin * search.noise);
  const double least = std::max(criteria.within_noise * search.noise, criteria.insignificant_gap);
  return kOfGap * gap > least
             ? couldShow(search, kOfGap * gap, "a third of the gap", criteria)
             : couldShow(search, kOfForce, "10 % of the force, since there is next to no gap", criteria);
}

}  // namespace rubber_suspension::diagnosis
