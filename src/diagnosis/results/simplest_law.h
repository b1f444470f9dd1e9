// The law with the fewest numbers that describes each named effect as well as the judged law does.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "diagnosis/results/law_fit.h"
#include "diagnosis/results/replayed.h"
#include "fit/fitter.h"

namespace rubber_suspension::diagnosis::results {

/// Returns the judged hypothesis as a law: of each member the terms with a scale other than 0, and at least one.
FittedLaw fullLaw(const hypotheses::FittedHypothesis& judged);

struct SimplestLaw {
  FittedLaw fitted;
  std::vector<WeighedLaw> others;  ///< of a gap that is small enough: the simplest of each other kind, and the
                                   ///< full law; odds by their errors
  std::vector<double> form_error;  ///< of each member, RMS over the standard deviation of the force
};

/// Chooses for each member in turn the law with the fewest numbers whose gap satisfies gap^2 <= full gap^2 + sum (eta
/// A)^2 + delta^2 over the members so far, with the force A that the member adds, the form error eta of laws and the
/// accepted error delta (JudgeNumbers), and which closes at least half of what the full law closes of the squared gap
/// `before`. A member that needs more numbers keeps its terms, and so does a single exact force that closes more than
/// half of what its element could. Laws are one to three terms of one kind, from the candidate and its `laws` at their
/// best places; terms of a contained effect are not used. Gaps are those of `replay` on the held-out logs, or else on
/// held-out blocks (replayed.h).
SimplestLaw simplestLaw(const fit::Fitter& fitter, const std::vector<fit::Candidate>& candidates,
                        const hypotheses::FittedHypothesis& judged, const std::vector<gap::PreparedRecord>& held_out,
                        double before, int threads);

}  // namespace rubber_suspension::diagnosis::results
