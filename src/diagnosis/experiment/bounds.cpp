// Derives the bounds of a proposed experiment.
#include "diagnosis/experiment/bounds.h"

#include <algorithm>
#include <cmath>

namespace rubber_suspension::diagnosis::experiment {

Stroke strokeOf(double low, double high) {
  constexpr double kSymmetric = 0.05;  // fraction of the half stroke; a smaller centre is an offset
  const Stroke stroke{0.5 * (low + high), 0.5 * (high - low)};
  return std::abs(stroke.centre) > kSymmetric * stroke.half ? stroke : Stroke{0.0, std::min(-low, high)};
}

Bounds boundsOf(const fit::Excitation& excitation, const std::vector<gap::PreparedRecord>& records,
                const ExperimentLimits& limits) {
  constexpr double kOverForce = 1.05;  // admits motions of the logs despite noise and errors of the fit
  double low = 0.0;
  double high = 0.0;
  double force = 0.0;
  bool first = true;
  for (const log::Record& record : records) {
    low = first ? record.displacement.minCoeff() : std::min(low, record.displacement.minCoeff());
    high = first ? record.displacement.maxCoeff() : std::max(high, record.displacement.maxCoeff());
    force = std::max(force, record.force.cwiseAbs().maxCoeff());
    first = false;
  }
  Bounds bounds;
  bounds.stroke = limits.stroke ? Stroke{0.0, *limits.stroke} : strokeOf(low, high);
  bounds.speed = limits.speed.value_or(excitation.highest_rate);
  bounds.frequency = limits.frequency.value_or(excitation.highest_frequency);
  bounds.force = limits.force.value_or(kOverForce * force);
  bounds.duration = limits.duration.value_or(excitation.longest_duration);
  bounds.dt = excitation.dt;
  return bounds;
}

}  // namespace rubber_suspension::diagnosis::experiment
