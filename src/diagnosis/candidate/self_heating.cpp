// Candidate effect: stiffness that falls as the rubber warms.
#include "rubber_suspension/diagnosis/candidate/catalogue.h"

namespace rubber_suspension::diagnosis {

fit::Candidate selfHeatingCandidate(const fit::Excitation& excitation) {
  fit::Candidate candidate{
      "self_heating", "heating by loss: stiffness falls over minutes of hard work, recovers at rest", false, {}, false};
  for (const double time : {10.0, 40.0, 160.0, 640.0}) {
    const double typical = 0.5 / (excitation.power * time);
    fit::Atom atom = fit::additiveAtom("self_heating", "energy_sensitivity", typical, {{"time_constant", {time}}});
    atom.additive = false;
    candidate.atoms.push_back(atom);
  }
  return candidate;
}

}  // namespace rubber_suspension::diagnosis
