// Candidate effect: a bracket or rig that yields.
#include "rubber_suspension/diagnosis/candidate/catalogue.h"

namespace rubber_suspension {

Candidate seriesComplianceCandidate(const Excitation& excitation) {
  Atom atom;
  atom.at = [](double compliance) {
    return ElementDescription{"series_compliance", {{"stiffness", {1.0 / compliance}}}};
  };
  atom.typical = 0.05 / excitation.stiffness;
  atom.upper = 1.0 / excitation.stiffness;
  atom.additive = false;
  return {"series_compliance",
          "rig or bracket that yields: error grows with stiffness whatever the frequency",
          true,
          {atom},
          false};
}

}  // namespace rubber_suspension
