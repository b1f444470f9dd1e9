// Candidate effect: a force that drifts with time.
#include "diagnosis/effect.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

void addForceDrift(const fit::Excitation& excitation, fit::Candidate& candidate) {
  fit::BasisTerm term = fit::additiveTerm("force_drift", "rate", 0.02 * excitation.force / excitation.longest_duration);
  term.lower = -term.upper;
  term.on_rig = true;
  candidate.terms = {term};
  candidate.free_in_log.trend = true;
}

const EffectEntry kForceDrift({150, "force_drift", "drift of the load cell: loops do not close at any displacement",
                               true, addForceDrift, InSettledLoops::no_part_of_loop});

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
