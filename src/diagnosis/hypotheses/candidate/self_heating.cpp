// Candidate effect: a stiffness that falls as the rubber warms.
#include "diagnosis/effect.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

void addSelfHeating(const fit::Excitation& excitation, fit::Candidate& candidate) {
  for (const double time : {10.0, 40.0, 160.0, 640.0}) {
    const double typical = 0.5 / (excitation.power * time);
    fit::BasisTerm term = fit::additiveTerm("self_heating", "energy_sensitivity", typical, {{"time_constant", {time}}});
    term.additive = false;
    candidate.terms.push_back(term);
  }
}

Effect selfHeating() {
  Effect effect{100,   "self_heating", "heating by loss: stiffness falls over minutes of motion and recovers at rest",
                false, addSelfHeating, InSettledLoops::over_before};
  effect.falls_like_warming = true;
  effect.not_beside_tables = "but a table contains only the warm state at the end of each sine";
  return effect;
}

const EffectEntry kSelfHeating(selfHeating());

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
