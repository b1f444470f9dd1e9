// Candidate effect: linear viscous damping.
#include "rubber_suspension/diagnosis/candidate/catalogue.h"

namespace rubber_suspension {

Candidate viscousDampingCandidate(const Excitation& excitation) {
  const double typical = 0.05 * excitation.stiffness / (6.28 * excitation.highest_frequency);
  return {"viscous_damping",
          "dashpot: loss force grows with frequency",
          false,
          {additiveAtom("dashpot", "damping", typical, {{"order", {2.0}}})}};
}

}  // namespace rubber_suspension
