// Where the fits of effects start: each keeps the best of what it arrives at.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "fit/hypothesis_fitter.h"

namespace rubber_suspension::diagnosis {

/// A single effect, from where the model parameters alone arrived, and from where it gets with the configured ones kept
/// if these are far from there or if it changes what the others do; in the latter case from no effect, too.
void fitSingle(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated, FittedHypothesis& single);

/// Gains of each log from where one gain of all arrived, which is enough where they do no better.
void fitGains(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated, FittedHypothesis& single);

/// Several effects, from where some of them arrived.
void fitFurther(const fit::HypothesisFitter& fitter, const std::vector<fit::Candidate>& candidates,
                const FittedHypothesis& from, FittedHypothesis& further);

}  // namespace rubber_suspension::diagnosis
