// A displacement filtered from the noise of its sensor by play.
#pragma once

#include <algorithm>

namespace rubber_suspension::element {

/// Purpose of the parameter of that name.
constexpr const char* kDeadBand = "ten standard deviations of the displacement's noise; 0 for simulated displacements";

/// The displacement [m] behind play of this width: it follows only what moves on beyond a dead band [m].
inline double followed(double displacement, double dead_band, double before) {
  return std::clamp(before, displacement - 0.5 * dead_band, displacement + 0.5 * dead_band);
}

/// Advances the place behind the play by one step; returns its displacement [m].
inline double advance(double displacement, double dead_band, double& place) {
  const double before = place;
  place = followed(displacement, dead_band, before);
  return place - before;
}

}  // namespace rubber_suspension::element
