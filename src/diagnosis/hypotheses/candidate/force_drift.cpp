// Candidate effect: a force that drifts with time.
#include "diagnosis/hypotheses/candidate/registry.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

fit::Candidate forceDrift(const fit::Excitation& excitation) {
  fit::BasisTerm term = fit::additiveTerm("force_drift", "rate", 0.02 * excitation.force / excitation.longest_duration);
  term.lower = -term.upper;
  term.on_rig = true;
  fit::Candidate candidate{
      "force_drift", "drift of the load cell: open loops, whatever the displacement", true, {term}};
  candidate.free_in_log.trend = true;
  return candidate;
}

const CandidateEntry kForceDriftEntry(150, forceDrift);

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
