// Gains and offsets that differ between logs: errors of the rig in these logs, which belong in no component file.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::results {

/// Marks values farther than `alike` from the median. Marks all values if no more than half of them lie so near; marks
/// all but the median if all do.
std::vector<bool> unlikeMost(const std::vector<double>& values, double alike);

/// Returns the errors of single logs if a judged hypothesis has a gain or offset of each log: the gain of logs that
/// differ from most, the offset of all; first the logs of the fit, then those held out. Empty if it has none, or only
/// those that the logs already have, so that the repeated search ends.
std::vector<gap::OwnErrors> ownErrors(const hypotheses::PreparedCase& prepared,
                                      const hypotheses::FittedHypothesis& judged);

}  // namespace rubber_suspension::diagnosis::results
