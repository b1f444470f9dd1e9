// Where relaxation ends and creep begins.
#pragma once

#include <algorithm>

#include "fit/excitation.h"

namespace rubber_suspension::diagnosis {

/// The relaxation time [s] beyond which relaxation is creep: 5 s, and no less than the largest displacement takes at
/// the highest rate of the logs. What is slower than the motion shows under a hold, but not in the loops; a slow test
/// has slow loops.
inline double longestRelaxationTime(const fit::Excitation& excitation) {
  constexpr double kLongest = 5.0;  // [s]
  return std::max(kLongest, excitation.largest_displacement / excitation.highest_rate);
}

}  // namespace rubber_suspension::diagnosis
