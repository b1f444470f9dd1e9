// Gains and zeros that differ between logs: errors of the rig in these logs, which belong into no component file.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::results {

/// Marks values of logs that are farther than `alike` from that of most. Marks all if no value is that of more than
/// half; all but the middle one if all are alike.
std::vector<bool> unlikeMost(const std::vector<double>& values, double alike);

/// Errors of single logs if a judged hypothesis has a gain or offset of each log: the gain of logs that differ from
/// most, the offset of all; first the logs of the fit, then those held out. Empty if it has none, or only those that
/// the logs already have, so that the repeated search ends.
std::vector<gap::OwnErrors> ownErrors(const hypotheses::PreparedCase& prepared,
                                      const hypotheses::FittedHypothesis& judged);

}  // namespace rubber_suspension::diagnosis::results
