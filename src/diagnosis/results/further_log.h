// Predicts the gap on a further log of the same rig.
#pragma once

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/results/law_fit.h"

namespace rubber_suspension::diagnosis::results {

/// Returns the gap that a further log would have. For each log, the law is fitted to all other logs, starting from the
/// fit to all logs, and the gap is computed with only an offset removed. The result is the RMS of these gaps. Returns
/// kNotComputed if there are fewer than three logs, or if there are held-out logs, which show this gap directly.
/// `fitted` is null for the component as configured, which needs no fit.
double gapOfFurtherLog(const hypotheses::PreparedCase& prepared, const FittedLaw* fitted, int threads);

}  // namespace rubber_suspension::diagnosis::results
