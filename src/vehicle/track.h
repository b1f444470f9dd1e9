// The track below the vehicle: its height as a function of time, smooth between the samples of a log.
#pragma once

#include <memory>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::vehicle {

/// Height of the track under a wheel as a function of time. It is a cubic spline through the samples, since an
/// integrator of higher order needs a smooth input. The track is level before the first and after the last sample.
class Track {
 public:
  /// Makes a level track at height 0.
  Track() = default;

  /// Makes a track from the displacement [m] of a log. Throws LogError as checkLog does, or for fewer than 4 samples.
  explicit Track(const log::Log& log);

  /// Returns the height [m] at a time [s] from the start of the log.
  double height(double time) const;

  double duration() const { return duration_; }  ///< [s]

 private:
  struct Spline;

  std::shared_ptr<const Spline> spline_;  // null for a level track
  double duration_ = 0.0;
  double first_ = 0.0;
  double last_ = 0.0;
};

}  // namespace rubber_suspension::vehicle
