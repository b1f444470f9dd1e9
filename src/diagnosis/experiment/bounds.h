// Bounds of a proposed experiment: those that the user allows, or that the logs reached.
#pragma once

#include <vector>

#include "fit/excitation.h"
#include "rubber_suspension/diagnosis/experiment_limits.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::experiment {

/// Where a motion may be: about `centre`, by `half` to either side [m].
struct Stroke {
  double centre = 0.0;
  double half = 0.0;
};

/// Stroke of displacements from `low` to `high`. If that is nearly symmetric, the centre is 0 and the smaller side
/// counts.
Stroke strokeOf(double low, double high);

/// The bounds of an experiment.
struct Bounds {
  Stroke stroke;
  double speed = 0.0;      ///< largest |dz/dt| [m/s]
  double frequency = 0.0;  ///< highest [Hz]
  double force = 0.0;      ///< largest |F| of any explanation [N]
  double duration = 0.0;   ///< from rest at 0 to rest at 0 [s]
  double dt = 0.0;         ///< no finer steps than these [s]
};

/// The limits given; where one is not, what the logs reached.
Bounds boundsOf(const fit::Excitation& excitation, const std::vector<gap::PreparedRecord>& records,
                const ExperimentLimits& limits);

}  // namespace rubber_suspension::diagnosis::experiment
