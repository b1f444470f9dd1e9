// Candidate effect: mass that moves with the displacement.
#include "rubber_suspension/diagnosis/candidate/catalogue.h"

namespace rubber_suspension {

Candidate inertiaCandidate(const Excitation& excitation) {
  const double omega = 6.28 * excitation.highest_frequency;
  return {"inertia",
          "moving fixture: error of stiffness grows with frequency squared, in phase",
          true,
          {additiveAtom("inertia", "mass", 0.05 * excitation.stiffness / (omega * omega))}};
}

}  // namespace rubber_suspension
