// Chooses the law with the fewest numbers that describes each named effect as well as the judged law does.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "diagnosis/results/law_fit.h"
#include "diagnosis/results/replayed.h"
#include "fit/fitter.h"

namespace rubber_suspension::diagnosis::results {

/// Returns the judged hypothesis as a law. Each effect keeps its terms with a scale other than 0, but at least one
/// term.
FittedLaw fullLaw(const hypotheses::FittedHypothesis& judged);

struct SimplestLaw {
  FittedLaw fitted;
  /// Other laws with a small enough gap, and their odds: the simplest law of each other kind, and the full law.
  std::vector<WeighedLaw> others;
  /// RMS form error of each effect, divided by the standard deviation of the force.
  std::vector<double> form_error;
};

/// Chooses for each effect in turn the law with the fewest numbers that satisfies two conditions. First, the squared
/// gap of the law exceeds that of the full law by at most delta^2 plus the sum of (eta A)^2 over the effects simplified
/// so far. Here, A is the RMS force that an effect adds, eta the form error of laws, and delta the accepted error
/// (JudgeNumbers). Second, the law closes at least half of the squared gap that the full law closes; `before` is the
/// gap without the law. An effect for which no law satisfies both conditions keeps its terms, and so does a single
/// exact term (BasisTerm::exact) that closes more than half of what its element could. Laws are one to three terms of
/// one kind, from the candidate and its `laws`. Gaps are those of `replay` on the held-out logs, or on held-out blocks
/// if there are none (replayed.h).
SimplestLaw simplestLaw(const fit::Fitter& fitter, const std::vector<fit::Candidate>& candidates,
                        const hypotheses::FittedHypothesis& judged, const std::vector<gap::PreparedRecord>& held_out,
                        double before, int threads);

}  // namespace rubber_suspension::diagnosis::results
