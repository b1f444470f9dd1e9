// Candidate effect: a dead zone about zero.
#include "rubber_suspension/diagnosis/candidate/catalogue.h"

namespace rubber_suspension {

Candidate freePlayCandidate(const Excitation& excitation) {
  Atom atom = additiveAtom("free_play", "gap", 0.03 * excitation.largest_displacement);
  atom.upper = 0.8 * excitation.largest_displacement;
  atom.additive = false;
  return {"free_play", "dead zone: stiffness falls at small amplitude", true, {atom}};
}

}  // namespace rubber_suspension
