// Candidate effect: rate-independent friction of any smoothness.
#include "rubber_suspension/diagnosis/candidate/catalogue.h"

namespace rubber_suspension::diagnosis {

fit::Candidate frictionCandidate(const fit::Excitation& excitation) {
  fit::Candidate candidate{
      "friction", "rate-independent friction: stiffness falls with amplitude at any frequency", false, {}, false};
  // Stop operators over the range of amplitudes: with stiffnesses of 0 or more they compose any friction that obeys
  // Masing's rule (Coulomb, Dahl, Iwan) and come close to those that nearly do (Berg, Bouc-Wen).
  for (const double share : {0.006, 0.015, 0.035, 0.075, 0.15, 0.27, 0.45, 0.7}) {
    const double yield = share * excitation.largest_displacement;
    fit::Atom atom;
    atom.typical = 0.1 * excitation.stiffness;
    atom.at = [yield](double stiffness) {
      return element::ElementDescription{"iwan_table", {{"yield_displacement", {yield}}, {"stiffness", {stiffness}}}};
    };
    candidate.atoms.push_back(atom);
  }
  return candidate;
}

}  // namespace rubber_suspension::diagnosis
