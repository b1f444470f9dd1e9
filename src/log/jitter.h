// What counts as an even time step.
#pragma once

namespace rubber_suspension::log {

constexpr double kJitterAllowed = 0.02;  ///< of the median step; more is resampled

}  // namespace rubber_suspension::log
