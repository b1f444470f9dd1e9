// Where relaxation ends and creep begins.
#pragma once

#include <algorithm>

#include "fit/excitation.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {

/// The relaxation time [s] beyond which relaxation is creep: thirty cycles of the fastest log, which is 5 s at 6 Hz; a
/// tenth of the longest log where that is shorter, so that a decade of creep shows; and no less than the slowest loop
/// takes. What is slower than the motion shows under a hold, but not in the loops; a slow test has slow loops.
inline double longestRelaxationTime(const fit::Excitation& excitation) {
  constexpr double kCycles = 30.0;
  constexpr double kOfLog = 0.1;
  const double slower_than_motion = std::min(kCycles / excitation.mean_frequency, kOfLog * excitation.longest_duration);
  return std::max(slower_than_motion, excitation.slowest_loop);
}

}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
