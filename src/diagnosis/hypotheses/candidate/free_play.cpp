// Candidate effect: a dead zone about zero.
#include "diagnosis/hypotheses/candidate/registry.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

// Dead zones one after the other, each taking a share of the motion within it: sharp or soft edges.
fit::Candidate freePlay(const fit::Excitation& excitation) {
  fit::Candidate candidate{"free_play", "dead zone: stiffness falls at small amplitude", true, {}};
  for (const double size : {0.01, 0.025, 0.06, 0.12, 0.22, 0.4}) {
    fit::BasisTerm term =
        fit::additiveTerm("free_play", "share", 0.3, {{"gap", {size * excitation.largest_displacement}}});
    term.upper = 1.0;
    term.additive = false;
    candidate.terms.push_back(term);
  }
  return candidate;
}

const CandidateEntry kFreePlayEntry(80, freePlay);

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
