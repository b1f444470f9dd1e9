// After the verdict: the law with the fewest numbers that says as much of each effect as the one that was judged.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "diagnosis/results/law_fit.h"
#include "diagnosis/results/replayed.h"
#include "fit/fitter.h"

namespace rubber_suspension::diagnosis::results {

/// The hypothesis as it was judged, each member by all its terms.
FittedLaw fullLaw(const hypotheses::FittedHypothesis& judged);

struct SimplestLaw {
  FittedLaw fitted;
  std::vector<WeighedLaw> others;  ///< that no gap tells from it: the simplest of each other form, and the full one;
                                   ///< odds by their errors
  std::vector<double> form_error;  ///< of each member, by which its law may differ from the rubber's: of the force
};

/// For each member in turn the law with the fewest numbers whose gap is that of the full law but for what no law of the
/// effect can know: gap^2 <= full gap^2 + sum (eta A)^2 + delta^2 over the members so far, A being the force that the
/// member adds, eta the form error of laws and delta what is accepted (JudgeNumbers). A member that needs more keeps
/// its terms, and so does one of a single exact force if that closes more than half of what its element could. Laws are
/// one to three terms of one kind, of those of the candidate and of its `laws`, at their best places; no term of what
/// an effect contains stands for it. Gaps are those of `replay` on the logs held out, or else on held-out blocks
/// (replayed.h). It closes more than half of what the full law closes of the squared gap `before`.
SimplestLaw simplestLaw(const fit::Fitter& fitter, const std::vector<fit::Candidate>& candidates,
                        const hypotheses::FittedHypothesis& judged, const std::vector<gap::PreparedRecord>& held_out,
                        double before, int threads);

}  // namespace rubber_suspension::diagnosis::results
