// Candidate effect: unlike stiffness in tension and compression.
#include "rubber_suspension/diagnosis/candidate/catalogue.h"

namespace rubber_suspension {

Candidate asymmetricStiffnessCandidate(const Excitation& excitation) {
  const double typical = 0.1 * excitation.stiffness;
  Candidate candidate{"asymmetric_stiffness",
                      "even stiffness: second harmonic, mean force grows with amplitude squared",
                      false,
                      {additiveAtom("asymmetric_stiffness", "quadratic", typical / excitation.largest_displacement),
                       additiveAtom("asymmetric_stiffness", "tension_stiffness", typical)}};
  for (Atom& atom : candidate.atoms) {
    atom.lower = -atom.upper;
  }
  return candidate;
}

}  // namespace rubber_suspension
