// Candidate effect: displacement or force that is recorded late.
#include <algorithm>

#include "diagnosis/hypotheses/candidate/registry.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

fit::Candidate timeDelay(const fit::Excitation& excitation) {
  fit::BasisTerm term = fit::additiveTerm("time_delay", "delay", excitation.dt);
  term.lower = -std::min(4.0 * excitation.dt, 0.02);
  term.upper = 0.03;
  term.typical = std::min(term.typical, 0.5 * term.upper);  // of a slow log no step beyond what the element takes
  term.additive = false;
  fit::Candidate candidate{
      "time_delay", "displacement or force recorded late: error of phase grows with frequency", true, {term}};
  candidate.one_form = true;
  return candidate;
}

const CandidateEntry kTimeDelayEntry(130, timeDelay);

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
