// The last cycles of a log: what a figure can show without running into one area.
#pragma once

#include <cstddef>
#include <vector>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::gap {

/// The samples at which the motion has crossed its mean, noise apart, in one direction and the other by turns.
std::vector<std::size_t> meanCrossings(const log::Log& log);

/// Mean frequency of the motion [Hz]: half the number of crossings of its mean, noise apart, over the duration; 0 where
/// there are none.
double meanFrequency(const log::Log& log);

/// The first sample of the last `cycles` of that frequency; 0 where the log has no more, or the frequency is 0.
std::size_t firstOfLastCycles(const log::Log& log, double frequency, double cycles);

}  // namespace rubber_suspension::gap
