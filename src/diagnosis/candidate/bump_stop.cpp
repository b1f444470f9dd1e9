// Candidate effect: a stop that is met beyond a gap.
#include "rubber_suspension/diagnosis/candidate/catalogue.h"

namespace rubber_suspension::diagnosis {

fit::Candidate bumpStopCandidate(const fit::Excitation& excitation) {
  fit::Candidate candidate{
      "bump_stop", "stop beyond a gap on one or both sides: a knee, error only beyond it", false, {}, false};
  for (const double side : {0.0, 1.0, -1.0}) {
    for (const double share : {0.4, 0.5, 0.6, 0.7, 0.8, 0.9}) {
      candidate.atoms.push_back(
          fit::additiveAtom("bump_stop", "stiffness", excitation.stiffness,
                            {{"gap", {share * excitation.largest_displacement}}, {"side", {side}}}));
    }
  }
  return candidate;
}

}  // namespace rubber_suspension::diagnosis
