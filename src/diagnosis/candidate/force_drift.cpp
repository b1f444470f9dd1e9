// Candidate effect: a force that drifts with time.
#include "rubber_suspension/diagnosis/candidate/catalogue.h"

namespace rubber_suspension::diagnosis {

fit::Candidate forceDriftCandidate(const fit::Excitation& excitation) {
  fit::Atom atom = fit::additiveAtom("force_drift", "rate", 0.02 * excitation.force / excitation.longest_duration);
  atom.lower = -atom.upper;
  atom.on_rig = true;
  return {"force_drift", "drift of the load cell: open loops, whatever the displacement", true, {atom}, true};
}

}  // namespace rubber_suspension::diagnosis
