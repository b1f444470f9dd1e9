// Candidate effect: a constant force.
#include "diagnosis/hypotheses/candidate/registry.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

fit::Candidate forceOffset(const fit::Excitation& excitation) {
  fit::BasisTerm term = fit::additiveTerm("force_offset", "offset", 0.02 * excitation.force);
  term.lower = -term.upper;
  term.on_rig = true;
  fit::Candidate candidate{"force_offset", "zero of the load cell: error of the mean only", true, {term}};
  return candidate;
}

const CandidateEntry kForceOffsetEntry(140, forceOffset);

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
