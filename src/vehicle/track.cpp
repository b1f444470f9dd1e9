// The track below the vehicle.
#include "vehicle/track.h"

#include <Simbody.h>

#include "element/refuse.h"

namespace rubber_suspension::vehicle {
namespace {

constexpr int kCubic = 3;
constexpr std::size_t kFewest = 4;

}  // namespace

struct Track::Spline {
  SimTK::Spline curve;
};

Track::Track(const log::Log& log) {
  log::checkLog(log);
  element::refuseIf<log::LogError>(log.size() < kFewest,
                                   "{}: the log is too short for a track; accepted: at least four samples", log.name);
  SimTK::Vector time(static_cast<int>(log.size()));
  SimTK::Vector height(static_cast<int>(log.size()));
  for (std::size_t i = 0; i < log.size(); ++i) {
    time[static_cast<int>(i)] = log.duration(0, i);
    height[static_cast<int>(i)] = log.displacement[i];
  }
  spline_ = std::make_shared<Spline>(
      Spline{SimTK::SplineFitter<double>::fitForSmoothingParameter(kCubic, time, height, 0.0).getSpline()});
  duration_ = log.duration(0, log.size() - 1);
  first_ = log.displacement.front();
  last_ = log.displacement.back();
}

double Track::height(double time) const {
  if (time <= 0.0) {
    return first_;
  }
  return time >= duration_ ? last_ : spline_->curve.calcValue(time);
}

}  // namespace rubber_suspension::vehicle
