// Candidate effect: displacement or force that is recorded late.
#include <algorithm>

#include "rubber_suspension/diagnosis/candidate/catalogue.h"

namespace rubber_suspension::diagnosis {

fit::Candidate timeDelayCandidate(const fit::Excitation& excitation) {
  fit::Atom atom = fit::additiveAtom("time_delay", "delay", excitation.dt);
  atom.lower = -std::min(4.0 * excitation.dt, 0.02);
  atom.upper = 0.03;
  atom.additive = false;
  return {
      "time_delay", "displacement or force recorded late: error of phase grows with frequency", true, {atom}, false};
}

}  // namespace rubber_suspension::diagnosis
