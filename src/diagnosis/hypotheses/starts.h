// Fits of effects from several starts; each keeps the best result.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "fit/hypothesis_fitter.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// Fits a single effect from `start`, where the normal equations predict its least error, and from the starts of its
/// terms. If the model parameters moved far or the effect is not additive, fits it also from the configured values.
/// Fits with errors above `reach`, in units of the force's standard deviation, are abandoned.
void fitSingle(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated,
               const fit::ParameterVector& start, double reach, FittedHypothesis& single);

/// Fits one gain of all logs beside the configured values. If gains may differ between logs, also fits a gain of each
/// log beside free values, which has to be clearly better than the common gain and than other values alone.
void fitGains(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated, double reach,
              FittedHypothesis& single);

/// Fits several effects from `start`, where the normal equations predict the least error, or else from the fit `from`
/// of some of them.
void fitFurther(const fit::HypothesisFitter& fitter, const FittedHypothesis& from, const fit::ParameterVector& start,
                double reach, FittedHypothesis& further);

/// Fits a hypothesis from the fit of one whose terms are among its own, so that its error in sample is not larger.
void fitBeyond(const fit::HypothesisFitter& fitter, const FittedHypothesis& from, FittedHypothesis& larger);

/// Returns a fitted hypothesis with a factor on the friction of each log, not refitted if its gap exceeds `reach`.
FittedHypothesis withFactors(const fit::HypothesisFitter& fitter, const FittedHypothesis& from, double reach);

/// Fits the members of a fitted hypothesis with one of them along a curve.
void fitCurved(const fit::HypothesisFitter& fitter, const FittedHypothesis& from, double reach,
               FittedHypothesis& curved);

}  // namespace rubber_suspension::diagnosis::hypotheses
