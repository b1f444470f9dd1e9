// Play that filters noise out of a measured displacement.
#pragma once

#include <algorithm>

namespace rubber_suspension::element {

/// Documentation of the parameter `dead_band`.
constexpr const char* kDeadBand =
    "width of the play that removes the displacement's noise, about ten standard deviations; 0 for simulated "
    "displacements";

/// Returns the displacement [m] behind play of total width `dead_band` [m]; `before` is the last displacement behind
/// it.
inline double followed(double displacement, double dead_band, double before) {
  return std::clamp(before, displacement - 0.5 * dead_band, displacement + 0.5 * dead_band);
}

/// Advances the displacement behind the play, `place` [m], by one step; returns its increment [m].
inline double advance(double displacement, double dead_band, double& place) {
  const double before = place;
  place = followed(displacement, dead_band, before);
  return place - before;
}

}  // namespace rubber_suspension::element
