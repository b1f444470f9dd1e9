// The gap that a further log of the same rig will show.
#pragma once

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/results/law_fit.h"

namespace rubber_suspension::diagnosis::results {

/// Root mean square over the logs of the gap of a law that was fitted to all others, from where the fit to all ended,
/// with only an offset removed. kNotComputed where there are fewer than three logs, or hold-outs, which tell it.
/// `fitted`: null for the component as configured, which nothing is fitted of.
double gapOfFurtherLog(const hypotheses::PreparedCase& prepared, const FittedLaw* fitted, int threads);

}  // namespace rubber_suspension::diagnosis::results
