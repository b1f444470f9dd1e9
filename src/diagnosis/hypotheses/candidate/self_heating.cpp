// Candidate effect: stiffness that falls as the rubber warms.
#include "diagnosis/hypotheses/candidate/registry.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

fit::Candidate selfHeating(const fit::Excitation& excitation) {
  fit::Candidate candidate{
      "self_heating", "heating by loss: stiffness falls over minutes of hard work, recovers at rest", false, {}};
  for (const double time : {10.0, 40.0, 160.0, 640.0}) {
    const double typical = 0.5 / (excitation.power * time);
    fit::BasisTerm term = fit::additiveTerm("self_heating", "energy_sensitivity", typical, {{"time_constant", {time}}});
    term.additive = false;
    candidate.terms.push_back(term);
  }
  return candidate;
}

const CandidateEntry kSelfHeatingEntry(100, selfHeating);

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
