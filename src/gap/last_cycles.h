// The last cycles of a log: what a figure can show without running into one area.
#pragma once

#include <cstddef>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::gap {

/// Mean frequency of the motion [Hz]: half the number of crossings of its mean, noise apart, over the duration; 0 where
/// there are none.
double meanFrequency(const log::Log& log);

/// The first sample of the last `cycles` of that frequency; 0 where the log has no more, or the frequency is 0.
std::size_t firstOfLastCycles(const log::Log& log, double frequency, double cycles);

}  // namespace rubber_suspension::gap
