// Possible errors of the rig in each log, as columns with a prior that every fit includes.
#pragma once

#include <vector>

#include "fit/model_parameters.h"
#include "measurement/rig_noise.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/io/rig_tolerances.h"

namespace rubber_suspension::diagnosis::prepare {

/// Source of the scatter of offsets and delays: the logs, or, for simulated logs, the tolerances.
enum class RigScatter { as_found, as_tolerated };

/// The logs of a diagnosis with possible errors of their rig.
struct LogsOfRig {
  std::vector<gap::PreparedRecord> training;
  std::vector<gap::PreparedRecord> held_out;
};

/// Returns the records with priors of the errors that the rig may have added to each (gap::RigPrior): offset, delay,
/// clock, gain, the response to motion before the log, and noise slower than the motion as a random walk, each as wide
/// as its tolerance. One standard deviation of any of them counts as measurement::ErrorScale::oneDeviation(). If
/// offsets or delays scatter less over the logs than their tolerance, their priors are narrowed to that scatter, so
/// that effects have to explain what all logs have in common. Errors of a single record (gap::OwnErrors) may have any
/// size. The model is estimated again for these priors and for the weights of the logs (weightsByNoise()).
LogsOfRig withRigPriors(const fit::ModelParameters& model, const io::RigTolerances& tolerances,
                        const measurement::ErrorScale& scale, std::vector<gap::PreparedRecord> training,
                        std::vector<gap::PreparedRecord> held_out, RigScatter scatter = RigScatter::as_found);

}  // namespace rubber_suspension::diagnosis::prepare
