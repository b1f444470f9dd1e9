// Candidate effect: odd stiffening.
#include <cmath>

#include "rubber_suspension/diagnosis/candidate/catalogue.h"

namespace rubber_suspension::diagnosis {

fit::Candidate progressiveStiffnessCandidate(const fit::Excitation& excitation) {
  const double z = excitation.largest_displacement;
  const double typical = 0.2 * excitation.stiffness;
  fit::Candidate candidate{"progressive_stiffness",
                           "odd stiffening: stiffness rises with amplitude, no loss",
                           false,
                           {fit::additiveAtom("progressive_stiffness", "quadratic", typical / z),
                            fit::additiveAtom("progressive_stiffness", "cubic", typical / (z * z)),
                            fit::additiveAtom("progressive_stiffness", "quintic", typical / (z * z * z * z))}};
  for (const double share : {0.3, 0.15}) {  // steep, without a knee
    candidate.atoms.push_back(fit::additiveAtom("progressive_stiffness", "exponential",
                                                typical * std::exp(-1.0 / share),
                                                {{"exponential_scale", {share * z}}}));
  }
  return candidate;
}

}  // namespace rubber_suspension::diagnosis
