// Candidate effect: unlike stiffness in tension and compression.
#include <cmath>

#include "rubber_suspension/diagnosis/candidate/catalogue.h"

namespace rubber_suspension::diagnosis {

fit::Candidate asymmetricStiffnessCandidate(const fit::Excitation& excitation) {
  const double typical = 0.1 * excitation.stiffness;
  fit::Candidate candidate{
      "asymmetric_stiffness",
      "even stiffness: second harmonic, mean force grows with amplitude squared",
      false,
      {fit::additiveAtom("asymmetric_stiffness", "quadratic", typical / excitation.largest_displacement),
       fit::additiveAtom("asymmetric_stiffness", "tension_stiffness", typical)}};
  for (fit::Atom& atom : candidate.atoms) {
    atom.lower = -atom.upper;
  }
  // One side that stiffens steeply, without a knee.
  for (const double share : {0.3, -0.3, 0.15, -0.15}) {
    const double scale = share * excitation.largest_displacement;
    candidate.atoms.push_back(fit::additiveAtom("asymmetric_stiffness", "exponential",
                                                typical * std::exp(-1.0 / std::abs(share)),
                                                {{"exponential_scale", {scale}}}));
  }
  return candidate;
}

}  // namespace rubber_suspension::diagnosis
