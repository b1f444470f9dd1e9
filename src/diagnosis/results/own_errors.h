// Finds gains and offsets that differ between logs. They are errors of the rig and do not belong in a component file.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::results {

/// Returns true for each value that is farther than `alike` from the median. If at most half of the values lie within
/// `alike` of the median, all values are marked; if all values do, all except the median are marked.
std::vector<bool> unlikeMost(const std::vector<double>& values, double alike);

/// Returns the errors of single logs if the judged hypothesis fits a gain or an offset to each log: the gain of logs
/// that differ from most, and the offset of all logs. The logs of the fit come first, then those held out. Returns an
/// empty list if the hypothesis fits neither, or if the logs already have all of these errors, which ends a repeated
/// search.
std::vector<gap::OwnErrors> ownErrors(const hypotheses::PreparedCase& prepared,
                                      const hypotheses::FittedHypothesis& judged);

}  // namespace rubber_suspension::diagnosis::results
