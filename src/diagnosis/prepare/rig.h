// The rig's part in the logs of a diagnosis: what it may have added to each, as columns with a prior that every fit
// has.
#pragma once

#include <vector>

#include "fit/model_parameters.h"
#include "measurement/rig_noise.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/io/rig_tolerances.h"

namespace rubber_suspension::diagnosis::prepare {

/// Source of the scatter of offsets and lags: the logs, or, for simulated logs, the tolerances.
enum class RigScatter { as_found, as_tolerated };

/// The logs of a diagnosis with possible errors of their rig.
struct LogsOfRig {
  std::vector<gap::PreparedRecord> training;
  std::vector<gap::PreparedRecord> held_out;
};

/// The records with what the rig may have added to each (gap::RigPrior): zero, lag, clock, gain, what a motion before
/// the log left, and noise slower than the motion as a random walk, each as wide as its tolerance. One standard
/// deviation of any of them counts as measurement::ErrorScale::oneDeviation(). Zeros and lags that are much alike in
/// all logs are no scatter of the rig: then they are no wider than they differ, and what they have in common is left to
/// the effects. What a record has for itself (gap::OwnErrors) may have any size. The model is re-estimated for that,
/// and for how much each log counts (weightsByNoise()).
LogsOfRig withRigPriors(const fit::ModelParameters& model, const io::RigTolerances& tolerances,
                        const measurement::ErrorScale& scale, std::vector<gap::PreparedRecord> training,
                        std::vector<gap::PreparedRecord> held_out, RigScatter scatter = RigScatter::as_found);

}  // namespace rubber_suspension::diagnosis::prepare
