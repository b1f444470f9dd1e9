// Fits of effects that start from several parameters and keep the best result.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "fit/hypothesis_fitter.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// Fits a single effect. The fit starts from `start`, for which the normal equations predict the least error, and from
/// the starting scales of its terms. If the effect is not additive or the re-estimated model parameters are far from
/// the configured ones, it also starts from the configured values. A fit is abandoned if its error exceeds `reach`,
/// which is divided by the standard deviation of the force.
void fitSingle(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated,
               const fit::ParameterVector& start, double reach, FittedHypothesis& single);

/// Fits one gain of all logs together with the configured values. If gains may differ between logs, also fits a gain
/// for each log with free model parameters, and keeps this fit if it is clearly better than one gain and than no gain.
void fitGains(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated, double reach,
              FittedHypothesis& single);

/// Fits several effects from `start`, for which normal equations predict the least error. If the error there is not
/// less than the error of `from`, a fit of some of the effects, the fit starts from the parameters of `from`.
void fitFurther(const fit::HypothesisFitter& fitter, const FittedHypothesis& from, const fit::ParameterVector& start,
                double reach, FittedHypothesis& further);

/// Fits a hypothesis from a fit whose terms it contains, so that its error on the data of the fit is not larger.
void fitBeyond(const fit::HypothesisFitter& fitter, const FittedHypothesis& from, FittedHypothesis& larger);

/// Returns a fitted hypothesis with a factor on the friction of each log, refitted if its gap is at most `reach`.
FittedHypothesis withFactors(const fit::HypothesisFitter& fitter, const FittedHypothesis& from, double reach);

/// Fits a hypothesis in which the law of one effect follows a curve. The fit starts from the parameters of `from`.
void fitCurved(const fit::HypothesisFitter& fitter, const FittedHypothesis& from, double reach,
               FittedHypothesis& curved);

}  // namespace rubber_suspension::diagnosis::hypotheses
