// Candidate effect: odd stiffening.
#include "rubber_suspension/diagnosis/candidate/catalogue.h"

namespace rubber_suspension {

Candidate progressiveStiffnessCandidate(const Excitation& excitation) {
  const double z = excitation.largest_displacement;
  const double typical = 0.2 * excitation.stiffness;
  return {"progressive_stiffness",
          "odd stiffening: stiffness rises with amplitude, no loss",
          false,
          {additiveAtom("progressive_stiffness", "quadratic", typical / z),
           additiveAtom("progressive_stiffness", "cubic", typical / (z * z)),
           additiveAtom("progressive_stiffness", "quintic", typical / (z * z * z * z))}};
}

}  // namespace rubber_suspension
