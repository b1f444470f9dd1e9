// Candidate effect: a force that drifts with time.
#include "diagnosis/candidate/registry.h"

namespace rubber_suspension::diagnosis {
namespace {

fit::Candidate forceDrift(const fit::Excitation& excitation) {
  fit::BasisTerm term = fit::additiveTerm("force_drift", "rate", 0.02 * excitation.force / excitation.longest_duration);
  term.lower = -term.upper;
  term.on_rig = true;
  return {"force_drift",
          "drift of the load cell: open loops, whatever the displacement",
          true,
          {term},
          {true, false},
          false,
          {"force_offset"}};
}

const CandidateEntry kEntry(150, forceDrift);

}  // namespace
}  // namespace rubber_suspension::diagnosis
