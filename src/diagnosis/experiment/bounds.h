// Bounds of a proposed experiment: those that the user allows, or that the logs reached.
#pragma once

#include <vector>

#include "fit/excitation.h"
#include "rubber_suspension/diagnosis/experiment_limits.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::experiment {

/// Range of a motion: `half` to either side of `centre` [m].
struct Stroke {
  double centre = 0.0;
  double half = 0.0;
};

/// Returns the stroke of displacements from `low` to `high`. If it is nearly symmetric, the centre is 0 and `half` is
/// the smaller side.
Stroke strokeOf(double low, double high);

/// The bounds of an experiment.
struct Bounds {
  Stroke stroke;
  double speed = 0.0;      ///< largest |dz/dt| [m/s]
  double frequency = 0.0;  ///< highest frequency of a motion [Hz]
  double force = 0.0;      ///< largest |F| that an explanation may predict [N]
  double duration = 0.0;   ///< from rest at 0 to rest at 0 [s]
  double dt = 0.0;         ///< shortest time step [s]
};

/// Returns the limits; for each that is not set, the value that the logs reached.
Bounds boundsOf(const fit::Excitation& excitation, const std::vector<gap::PreparedRecord>& records,
                const ExperimentLimits& limits);

}  // namespace rubber_suspension::diagnosis::experiment
