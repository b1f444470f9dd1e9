// Where the fits of effects start: each keeps the best of what it arrives at.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "fit/hypothesis_fitter.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// A single effect, from where the normal equations promise its least error: `start`. From where it gets with the
/// configured values kept, too, if the model parameters moved far or if it changes what the others do. Errors above
/// `reach`, in units of the force's standard deviation, are not followed further.
void fitSingle(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated,
               const fit::ParameterVector& start, double reach, FittedHypothesis& single);

/// One gain of all logs beside the configured values; where it may differ, a gain of each log beside values of their
/// own, if these do clearly better than that and than other values alone.
void fitGains(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated, double reach,
              FittedHypothesis& single);

/// Several effects, from where the normal equations about some of them promise the least error, or where these arrived.
void fitFurther(const fit::HypothesisFitter& fitter, const FittedHypothesis& from, const fit::ParameterVector& start,
                double reach, FittedHypothesis& further);

/// A hypothesis from where one arrived whose terms are among its own. It leaves no more of the logs than that.
void fitBeyond(const fit::HypothesisFitter& fitter, const FittedHypothesis& from, FittedHypothesis& larger);

/// A fitted hypothesis with a factor on the friction of each log; as it is where that leaves more than `reach`.
FittedHypothesis withFactors(const fit::HypothesisFitter& fitter, const FittedHypothesis& from, double reach);

/// The members of a fitted hypothesis, one of them along a curve.
void fitCurved(const fit::HypothesisFitter& fitter, const FittedHypothesis& from, double reach,
               FittedHypothesis& curved);

}  // namespace rubber_suspension::diagnosis::hypotheses
