// Gains and zeros that differ between logs: errors of the rig in these logs, which belong into no component file.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::results {

/// Marks values of logs that are farther than `alike` from that of most. Marks all if no value is that of more than
/// half; all but the middle one if all are alike.
std::vector<bool> unlikeMost(const std::vector<double>& values, double alike);

/// What each log has for itself where a judged hypothesis gives each log another gain or another zero: the gain of logs
/// that read otherwise than most do, the zero of all. The logs of the fit, then those held out. Empty where it gives
/// them none, or none that the logs do not have already: a search that is repeated with them ends.
std::vector<gap::OwnErrors> ownErrors(const hypotheses::PreparedCase& prepared,
                                      const hypotheses::FittedHypothesis& judged);

}  // namespace rubber_suspension::diagnosis::results
