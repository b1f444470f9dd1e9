// Values of sweeps in the units of figures, and curves of these values.
#pragma once

#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/io/figure.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::command {

constexpr double kDegrees = 180.0 / element::kPi;

using SweepQuantity = double (*)(const response::SweepPoint&);

/// Returns the frequency [Hz].
inline double frequencyOf(const response::SweepPoint& point) { return point.frequency; }

/// Returns the amplitude [mm].
inline double amplitudeOf(const response::SweepPoint& point) { return point.amplitude * 1e3; }

/// Returns the stiffness [kN/mm].
inline double stiffnessOf(const response::SweepPoint& point) { return point.characteristics.stiffness * 1e-6; }

/// Returns the loss angle [deg].
inline double angleOf(const response::SweepPoint& point) { return point.characteristics.loss_angle * kDegrees; }

/// The quantity on the horizontal axis of a sweep.
struct SweepAxis {
  const char* label;
  SweepQuantity value;
};
constexpr SweepAxis kOverFrequency{"frequency [Hz]", frequencyOf};
constexpr SweepAxis kOverAmplitude{"amplitude [mm]", amplitudeOf};

inline io::Curve curveThrough(const std::vector<response::SweepPoint>& points, const SweepAxis& along,
                              SweepQuantity quantity) {
  io::Curve curve;
  for (const response::SweepPoint& point : points) {
    curve.x.push_back(along.value(point));
    curve.y.push_back(quantity(point));
  }
  return curve;
}

/// Returns the options for a sine about a mean displacement [m].
inline response::LoopOptions loopsAbout(double mean) {
  response::LoopOptions options;
  options.mean = mean;
  return options;
}

}  // namespace rubber_suspension::command
