// Judges the effects that are added to the logs.
#include "diagnosis/experiment/confusion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>

#include "diagnosis/judge/answer.h"
#include "element/each.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis::experiment {
namespace {

using hypotheses::Implant;
using hypotheses::Search;
using judge::Answer;

constexpr double kLeastSize = 1e-4;  // fraction of the force at which the search for the least size begins
constexpr int kHalvings = 10;        // bisections of the logarithm of the size, which determine the size to 1 %

enum class Outcome { found, confounded, taken_for, unexplained, out_of_reach };

const char* outcomeName(Outcome outcome) {
  static const char* const names[] = {"found", "confounded", "taken_for", "unexplained", "out_of_reach"};
  return names[static_cast<int>(outcome)];
}

judge::HypothesisEvidence evidenceOf(const hypotheses::Residuals& residuals, double noise, double size) {
  judge::HypothesisEvidence evidence;
  evidence.log_errors = {noise * noise + std::pow(size * residuals.gap, 2)};
  evidence.chi_squared = std::pow(size * residuals.chi, 2);
  return evidence;
}

bool has(const std::vector<int>& effects, int effect) {
  return std::find(effects.begin(), effects.end(), effect) != effects.end();
}

Outcome outcomeOf(const Answer& answer, int effect) {
  if (answer.effects.empty()) {
    return answer.verdict == Verdict::unknown ? Outcome::unexplained : Outcome::out_of_reach;
  }
  if (has(answer.effects, effect) && answer.alternatives.empty()) {
    return Outcome::found;
  }
  const bool listed = std::any_of(answer.confounded.begin(), answer.confounded.end(),
                                  [&](const std::vector<int>& set) { return has(set, effect); });
  return listed ? Outcome::confounded : Outcome::taken_for;
}

// Returns the more frequent of found and confounded if these are at least half of the outcomes, else the commonest.
Outcome commonest(std::map<Outcome, double> outcomes) {
  if (outcomes[Outcome::found] + outcomes[Outcome::confounded] >= 0.5) {
    return outcomes[Outcome::found] < outcomes[Outcome::confounded] ? Outcome::confounded : Outcome::found;
  }
  return std::max_element(outcomes.begin(), outcomes.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

// Returns true if effects are named, but wrong values are an alternative.
bool valuesWouldDo(const Answer& answer) {
  return !answer.effects.empty() &&
         std::any_of(answer.alternatives.begin(), answer.alternatives.end(),
                     [](const judge::Explained& other) { return other.verdict == Verdict::parameter_error; });
}

// The judgement of one effect in several forms of its law.
class EffectRow {
 public:
  EffectRow(const Search& search, int effect) : search_(search), effect_(effect) {
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
    if (implants_.empty()) {  // the logs lack what the effect needs
      row.outcome = outcomeName(Outcome::out_of_reach);
      row.nothing_named = 1.0;
      row.least_size = std::numeric_limits<double>::infinity();
      return row;
    }
    const double share = 1.0 / static_cast<double>(implants_.size());
    std::map<Outcome, double> outcomes;
    std::map<int, double> in_its_place;
    for (const Implant* implant : implants_) {
      row.visible_share = std::max(row.visible_share, implant->adds_nothing ? 0.0 : implant->model.gap);
      const Answer answer = answerTo(*implant, size);
      outcomes[outcomeOf(answer, effect_)] += share;
      (answer.effects.empty() ? row.nothing_named : row.named_as[static_cast<std::size_t>(answer.effects.front())]) +=
          share;
      for (const int other : othersOf(answer)) {
        in_its_place[other] += share;
      }
    }
    row.outcome = outcomeName(commonest(outcomes));
    row.taken_for = byShare(in_its_place);
    row.least_size = leastSize();
    return row;
  }

 private:
  static constexpr int kWrongValues = -1;  // stands for wrong values where an index of an effect is expected

  std::string name(int effect) const {
    return effect == kWrongValues ? toString(Verdict::parameter_error)
                                  : search_.candidates[static_cast<std::size_t>(effect)].effect;
  }

  Answer answerTo(const Implant& implant, double size) const {
    return implant.adds_nothing ? Answer{} : judge::answer(experiment::evidenceOf(search_, implant, size));
  }

  // Returns the effects in the listed sets, except for this effect, and kWrongValues if wrong values are an
  // alternative.
  std::set<int> othersOf(const Answer& answer) const {
    std::set<int> others;
    for (const std::vector<int>& set : answer.confounded) {
      std::copy_if(set.begin(), set.end(), std::inserter(others, others.end()),
                   [&](int other) { return other != effect_; });
    }
    if (valuesWouldDo(answer)) {
      others.insert(kWrongValues);
    }
    return others;
  }

  // Returns the names that are listed for more than a fifth of the forms of the law, the most frequent first.
  std::vector<std::string> byShare(const std::map<int, double>& shares) const {
    constexpr double kToTell = 0.2;
    std::vector<std::pair<double, int>> order;
    for (const auto& [effect, share] : shares) {
      if (share > kToTell) {
        order.emplace_back(-share, effect);
      }
    }
    std::sort(order.begin(), order.end());
    return element::each(order, [&](const auto& entry) { return name(entry.second); });
  }

  bool halfIsFound(double size) const {
    std::size_t found = 0;
    for (const Implant* implant : implants_) {
      const Answer answer = answerTo(*implant, size);
      const Outcome outcome = outcomeOf(answer, effect_);
      const bool listed = outcome == Outcome::found || outcome == Outcome::confounded;
      found += listed && !valuesWouldDo(answer) ? 1 : 0;
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
  int effect_;
  std::vector<const Implant*> implants_;
};

}  // namespace

judge::Evidence evidenceOf(const Search& search, const Implant& implant, double size) {
  judge::Evidence evidence = hypotheses::evidenceOfNone(search);
  evidence.logs = {{search.noise.floor, 0.0, 1.0, false, implant.blocks}};
  evidence.hypotheses.push_back(evidenceOf(hypotheses::Residuals{}, search.noise.floor, size));
  evidence.hypotheses.push_back(evidenceOf(implant.model, search.noise.floor, size));
  for (std::size_t c = 0; c < search.candidates.size(); ++c) {
    const fit::Candidate& candidate = search.candidates[c];
    judge::HypothesisEvidence single = evidenceOf(implant.singles[c], search.noise.floor, size);
    single.members = {static_cast<int>(c)};
    single.sizes = {{std::pow(size * implant.singles[c].added, 2)}};
    single.terms = candidate.terms.size();
    single.beyond = implant.singles[c].beyond;
    single.free_in_log = candidate.free_in_log;
    evidence.hypotheses.push_back(std::move(single));
  }
  return evidence;
}

CouldShow couldShow(const Search& search, double size, const std::string& why) {
  CouldShow table;
  table.size = size;
  table.force = size * search.excitation.force;
  table.why = why;
  table.noise = search.noise.floor;
  for (std::size_t c = 0; c < search.candidates.size(); ++c) {
    table.effects.push_back(search.candidates[c].effect);
    table.implanted.push_back(EffectRow(search, static_cast<int>(c)).at(size));
  }
  return table;
}

CouldShow couldShow(const Search& search) {
  constexpr double kOfGap = 1.0 / 3.0;
  constexpr double kOfForce = 0.1;
  const double gap = gap::residualAboveFloor(search.configured_gap, search.noise.floor);
  return kOfGap * gap > std::max(judge::fittedNumbers().accepted, search.noise.floor)
             ? couldShow(search, kOfGap * gap, "a third of the gap")
             : couldShow(search, kOfForce, "10 % of the force, because there is hardly any gap");
}

}  // namespace rubber_suspension::diagnosis::experiment
