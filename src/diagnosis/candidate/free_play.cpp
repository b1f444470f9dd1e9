// Candidate effect: a dead zone about zero.
#include "rubber_suspension/diagnosis/candidate/catalogue.h"

namespace rubber_suspension::diagnosis {

// Dead zones one after the other, each taking a share of the motion within it: sharp or soft edges.
fit::Candidate freePlayCandidate(const fit::Excitation& excitation) {
  fit::Candidate candidate{"free_play", "dead zone: stiffness falls at small amplitude", true, {}, false};
  for (const double size : {0.01, 0.025, 0.06, 0.12, 0.22, 0.4}) {
    fit::Atom atom = fit::additiveAtom("free_play", "share", 0.3, {{"gap", {size * excitation.largest_displacement}}});
    atom.upper = 1.0;
    atom.additive = false;
    candidate.atoms.push_back(atom);
  }
  return candidate;
}

}  // namespace rubber_suspension::diagnosis
