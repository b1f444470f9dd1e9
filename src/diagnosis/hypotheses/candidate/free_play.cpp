// Candidate effect: a dead zone about zero displacement.
#include <numeric>

#include "diagnosis/effect.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

// Adds dead zones in series, each of which removes a share of the motion. Together they have sharp or soft edges.
void addFreePlay(const fit::Excitation& excitation, fit::Candidate& candidate) {
  for (const double size : {0.01, 0.025, 0.06, 0.12, 0.22, 0.4}) {
    fit::BasisTerm term =
        fit::additiveTerm("free_play", "share", 0.3, {{"gap", {size * excitation.largest_displacement}}});
    term.upper = 1.0;
    term.additive = false;
    candidate.terms.push_back(term);
  }
}

// Returns the motion that is lost in all dead zones together if the displacement is beyond each of them.
std::vector<HeadlineValue> lostMotion(const Effect::Entries& plays) {
  const double lost = std::accumulate(plays.begin(), plays.end(), 0.0, [](double sum, const auto& entry) {
    return sum + valueOr(entry, "share", 1.0) * entry.value("gap");
  });
  return {{plays.size() > 1 ? "total_gap" : "gap", "m", lost, true}};
}

Effect freePlay() {
  Effect effect{80, "free_play", "dead zone: stiffness is lower at small amplitude", true, addFreePlay};
  effect.headline = lostMotion;
  effect.headline_types = {effect.name};
  effect.labels = {{"gap", "gap on each side"}, {"total_gap", "gap on each side"}};
  return effect;
}

const EffectEntry kFreePlay(freePlay());

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
