// Finds the last cycles of a log, which a figure can show as separate loops.
#pragma once

#include <cstddef>
#include <vector>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::gap {

/// Returns the samples at which the motion crosses its mean. A hysteresis suppresses crossings due to noise.
std::vector<std::size_t> meanCrossings(const log::Log& log);

/// Returns the mean frequency of the motion [Hz]: half the number of meanCrossings() divided by the duration.
double meanFrequency(const log::Log& log);

/// Returns the first sample of the last `cycles` at this frequency; 0 if the log is shorter or the frequency is 0.
std::size_t firstOfLastCycles(const log::Log& log, double frequency, double cycles);

}  // namespace rubber_suspension::gap
