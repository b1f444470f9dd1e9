// Candidate effect: a displacement or force that is recorded late.
#include <algorithm>

#include "diagnosis/effect.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

void addTimeDelay(const fit::Excitation& excitation, fit::Candidate& candidate) {
  fit::BasisTerm term = fit::additiveTerm("time_delay", "delay", excitation.dt);
  term.lower = -std::min(4.0 * excitation.dt, 0.02);
  term.upper = 0.03;
  term.typical = std::min(term.typical, 0.5 * term.upper);  // a slow log's time step may exceed the element's range
  term.additive = false;
  candidate.terms = {term};
  candidate.one_form = true;
}

const EffectEntry kTimeDelay({130, "time_delay",
                              "displacement or force recorded late: the phase error grows with frequency", true,
                              addTimeDelay});

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
