// A track for tests: a sum of sines with a smooth start.
#pragma once

#include <cmath>
#include <vector>

#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/log/log.h"
#include "vehicle/simulation.h"

namespace rubber_suspension::vehicle {

struct TrackSine {
  double amplitude;  // [m]
  double rate;       // [rad/s]
  double phase;      // [rad]
};

/// Returns a track that is half a second longer than the run. Its sines reach their full amplitude.
inline Scene softTrack(const std::vector<TrackSine>& sines, double duration) {
  log::Log log;
  log.name = "track";
  for (int i = 0; i <= static_cast<int>(1000.0 * (duration + 0.5)); ++i) {
    const double t = 1e-3 * i;
    const double fade = t < 0.5 ? 0.5 - 0.5 * std::cos(2.0 * element::kPi * t) : 1.0;
    double height = 0.0;
    for (const TrackSine& sine : sines) {
      height += sine.amplitude * std::sin(sine.rate * t + sine.phase);
    }
    log.stamp.push_back(i * 1000000LL);
    log.displacement.push_back(fade * height);
  }
  Scene scene;
  scene.track = Track(log);
  scene.duration = duration;
  return scene;
}

}  // namespace rubber_suspension::vehicle
