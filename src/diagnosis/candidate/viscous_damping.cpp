// Candidate effect: viscous damping, linear or not.
#include "rubber_suspension/diagnosis/candidate/catalogue.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis {

fit::Candidate viscousDampingCandidate(const fit::Excitation& excitation) {
  const double typical = 0.05 * excitation.stiffness / (2.0 * element::kPi * excitation.highest_frequency);
  fit::Candidate candidate{"viscous_damping",
                           "dashpot: loss force grows with frequency",
                           false,
                           {fit::additiveAtom("dashpot", "damping", typical, {{"order", {2.0}}})}};
  for (const double exponent : {0.5, 2.0}) {  // thins under shear; flows through an orifice
    candidate.atoms.push_back(
        fit::additiveAtom("power_dashpot", "damping", typical,
                          {{"reference_rate", {excitation.highest_rate}}, {"exponent", {exponent}}}));
  }
  return candidate;
}

}  // namespace rubber_suspension::diagnosis
