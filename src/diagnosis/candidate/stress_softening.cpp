// Candidate effect: softening by past displacement.
#include "diagnosis/candidate/registry.h"

namespace rubber_suspension::diagnosis {
namespace {

// Shapes from a softening that sets in just below the largest past displacement to one that is felt at small
// displacement only; at once or over some cycles.
fit::Candidate stressSoftening(const fit::Excitation& excitation) {
  fit::Candidate candidate{
      "stress_softening", "softening below the largest past displacement, gone by cycle 3 to 5", false, {}, false};
  for (const double width : {0.05, 0.15, 0.5, 1.5}) {
    for (const double path : {0.0, 2.0, 8.0, 32.0}) {
      fit::BasisTerm term = fit::additiveTerm("stress_softening", "reduction", 0.1,
                                              {{"width", {width}}, {"path", {path * excitation.largest_displacement}}});
      term.upper = 0.8;
      term.additive = false;
      term.softening = true;
      candidate.terms.push_back(term);
    }
  }
  return candidate;
}

const CandidateEntry kEntry(90, stressSoftening);

}  // namespace
}  // namespace rubber_suspension::diagnosis
