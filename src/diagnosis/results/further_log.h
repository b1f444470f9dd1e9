// Predicted gap of a further log of the same rig.
#pragma once

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/results/law_fit.h"

namespace rubber_suspension::diagnosis::results {

/// Returns the RMS over the logs of the gap of a law that is fitted to all other logs, starting from the fit to all,
/// with only an offset removed. kNotComputed if there are fewer than three logs, or hold-outs, which give this gap
/// directly. `fitted`: null for the component as configured, which needs no fit.
double gapOfFurtherLog(const hypotheses::PreparedCase& prepared, const FittedLaw* fitted, int threads);

}  // namespace rubber_suspension::diagnosis::results
