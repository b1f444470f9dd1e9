// Candidate effect: a constant force.
#include "diagnosis/candidate/registry.h"

namespace rubber_suspension::diagnosis {
namespace {

fit::Candidate forceOffset(const fit::Excitation& excitation) {
  fit::BasisTerm term = fit::additiveTerm("force_offset", "offset", 0.02 * excitation.force);
  term.lower = -term.upper;
  term.on_rig = true;
  return {"force_offset", "zero of the load cell: error of the mean only", true, {term}};
}

const CandidateEntry kEntry(140, forceOffset);

}  // namespace
}  // namespace rubber_suspension::diagnosis
