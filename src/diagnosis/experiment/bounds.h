// Bounds of a proposed experiment. They are set by the user, or else by what the logs reached.
#pragma once

#include <vector>

#include "fit/excitation.h"
#include "rubber_suspension/diagnosis/experiment_limits.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::experiment {

/// Range of a motion: from centre - half to centre + half [m].
struct Stroke {
  double centre = 0.0;
  double half = 0.0;
};

/// Returns the stroke of displacements from `low` to `high`. If these are nearly symmetric about 0, the centre is 0 and
/// `half` is the smaller of their absolute values.
Stroke strokeOf(double low, double high);

struct Bounds {
  Stroke stroke;
  double speed = 0.0;      ///< largest |dz/dt| [m/s]
  double frequency = 0.0;  ///< highest frequency of a motion [Hz]
  double force = 0.0;      ///< largest |F| that an explanation may predict [N]
  double duration = 0.0;   ///< duration, including the beginning and the end at rest at displacement 0 [s]
  double dt = 0.0;         ///< shortest time step [s]
};

/// Returns the bounds that the limits set. A bound without a limit is derived from what the logs reached.
Bounds boundsOf(const fit::Excitation& excitation, const std::vector<gap::PreparedRecord>& records,
                const ExperimentLimits& limits);

}  // namespace rubber_suspension::diagnosis::experiment
