// Computes prior distributions of the errors of the rig in each log, which every fit includes.
#pragma once

#include <vector>

#include "fit/model_parameters.h"
#include "measurement/rig_noise.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/io/rig_tolerances.h"

namespace rubber_suspension::diagnosis::prepare {

/// States whether the priors of offsets and delays follow their scatter in the logs or, for simulated logs, the
/// tolerances.
enum class RigScatter { as_found, as_tolerated };

struct LogsOfRig {
  std::vector<gap::PreparedRecord> training;
  std::vector<gap::PreparedRecord> held_out;
};

/// Returns the records with prior distributions of the errors of the rig (gap::RigPrior). These errors are offset,
/// delay, clock, gain, response to the motion before the log, and slow noise as a random walk. The standard deviation
/// of each prior is the tolerance of the error, which counts in the fit as an error of
/// measurement::ErrorScale::oneDeviation(). If the offsets or delays of the logs scatter less than their tolerance,
/// their priors are narrowed to that scatter, so that effects have to explain what all logs have in common. Errors of a
/// single record (gap::OwnErrors) may have any size. The priors are computed at a model that is first fitted to the
/// logs. The records also get weights (weightsByNoise()).
LogsOfRig withRigPriors(const fit::ModelParameters& model, const io::RigTolerances& tolerances,
                        const measurement::ErrorScale& scale, std::vector<gap::PreparedRecord> training,
                        std::vector<gap::PreparedRecord> held_out, RigScatter scatter = RigScatter::as_found);

}  // namespace rubber_suspension::diagnosis::prepare
