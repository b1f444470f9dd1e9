// How sure it is which part of the gap a model closes.
#pragma once

#include <array>
#include <vector>

#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {

/// 95 % interval of the closed fraction by resampling the parts of the logs, paired, and the noise floor. The same
/// numbers at every call with the same seed.
std::array<double, 2> closedInterval(const std::vector<gap::PartError>& before,
                                     const std::vector<gap::PartError>& after, double floor, int resamplings,
                                     unsigned seed);

/// What two models err by on one log that was not fitted, or whose blocks were left out: mean squares, as gaps.
struct LogErrors {
  double before = 0.0;
  double after = 0.0;
  double floor = 0.0;   ///< noise of the log, as a gap
  double weight = 1.0;  ///< of the log (Record::weight)
};

/// 95 % interval of the fraction that an effect which is at work closes of eight further logs of the same rig: logs are
/// drawn, and what it leaves of each, by how that scatters from log to log.
///
/// The logarithm of what is left, over what was there before, is taken as normal over the logs of a rig, and as never
/// above 0, since a law that is at work opens no gap. Its scatter is that of the logs given and of other rigs before
/// them (an inverse chi-square, so that few logs make Student's t); its mean is off by the error of a mean of so many
/// logs, and by what all logs given have in common and further ones do not, since the law was fitted to them or chosen
/// by them.
std::array<double, 2> closedOnFurtherLogs(const std::vector<LogErrors>& logs, int resamplings, unsigned seed);

}  // namespace rubber_suspension::diagnosis
