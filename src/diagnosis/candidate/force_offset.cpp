// Candidate effect: a constant force.
#include "rubber_suspension/diagnosis/candidate/catalogue.h"

namespace rubber_suspension::diagnosis {

fit::Candidate forceOffsetCandidate(const fit::Excitation& excitation) {
  fit::Atom atom = fit::additiveAtom("force_offset", "offset", 0.02 * excitation.force);
  atom.lower = -atom.upper;
  atom.on_rig = true;
  return {"force_offset", "zero of the load cell: error of the mean only", true, {atom}, false};
}

}  // namespace rubber_suspension::diagnosis
