// Numbers of a search for the judgement.
#include "diagnosis/hypotheses/search_evidence.h"

#include <limits>

namespace rubber_suspension::diagnosis {
namespace {

HypothesisEvidence evidenceOf(const FittedHypothesis& fitted) {
  HypothesisEvidence evidence;
  evidence.members = fitted.hypothesis.members;
  evidence.terms = fitted.hypothesis.terms.size();
  evidence.free_trends = fitted.hypothesis.free_in_log.trend;
  evidence.free_gains = fitted.hypothesis.free_in_log.gain;
  const bool applies = !fitted.hypothesis.terms.empty() || fitted.hypothesis.members.empty();
  evidence.penalty = applies ? fitted.fit.penalty : std::numeric_limits<double>::infinity();  // nothing was fitted
  return evidence;
}

}  // namespace

Evidence evidenceOf(const Search& search) {
  Evidence evidence;
  evidence.hypotheses = {{}, evidenceOf(search.re_estimated)};
  for (const FittedHypothesis* fitted : search.withEffects()) {
    evidence.hypotheses.push_back(evidenceOf(*fitted));
  }
  for (const fit::Candidate& candidate : search.candidates) {
    evidence.effects.push_back(candidate.effect);
    evidence.on_rig.push_back(candidate.on_rig);
  }
  return evidence;
}

}  // namespace rubber_suspension::diagnosis
