// Errors of fitted hypotheses on logs that took no part in the fit.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "fit/free_in_log.h"
#include "fit/model_parameters.h"
#include "gap/simulate.h"
#include "measurement/rig_noise.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::hypotheses {

using UnseenErrors = std::vector<gap::PartError>;

/// Returns the force of a fitted hypothesis on records, each of which is of a new component [N]. The displacement is
/// smoothed as in the fits, because the noise of its sensor is an error of the rig.
gap::Forces predict(const fit::ModelParameters& model, const FittedHypothesis& fitted,
                    const std::vector<gap::PreparedRecord>& records);

/// Returns the errors of a fitted hypothesis on records, each of which is of a new component.
UnseenErrors unseenErrors(const fit::ModelParameters& model, const FittedHypothesis& fitted,
                          const std::vector<gap::PreparedRecord>& records);

/// Returns the errors of forces that elements predict. What the per-log nuisance parameters of a hypothesis explain,
/// such as an offset, does not count as an error.
UnseenErrors unseenErrors(fit::Hypothesis hypothesis, const std::vector<element::ElementDescription>& elements,
                          const gap::Forces& predicted, const std::vector<gap::PreparedRecord>& records);

/// Returns the friction force of a component on records, each of a new component (fit::frictionOf()).
gap::Forces frictionOfEach(const std::vector<element::ElementDescription>& elements,
                           const std::vector<gap::PreparedRecord>& records);

/// Returns the errors of a hypothesis on tenths of each record (gap::partErrors()). The values of per-log nuisance
/// parameters, which no simulation predicts, are fitted to the other tenths of the log.
std::vector<gap::PartError> partErrorsOf(const fit::Hypothesis& hypothesis,
                                         const std::vector<gap::PreparedRecord>& records, const gap::Forces& simulated);

/// Returns the mean error of each log. For a log without any part of positive weight, returns the value in `otherwise`.
std::vector<double> errorsByLog(const std::vector<gap::PartError>& parts, std::vector<double> otherwise);

/// Returns the per-log nuisance parameters that are removed before a noise floor is estimated. These are offsets and
/// gains. Trends are not removed, because they would absorb slow noise.
fit::PerLogNuisances freeOfNoise(const fit::Hypothesis& hypothesis);

/// Returns the noise floor of each record: the noise in the residual after removal of `free`, up to a limit. It is
/// larger if noise of the displacement causes a larger error of the friction, but at most the residual.
std::vector<double> noiseFloors(const std::vector<element::ElementDescription>& elements,
                                const fit::PerLogNuisances& free, const gap::Forces& simulated,
                                const std::vector<gap::PreparedRecord>& records, const measurement::NoiseLimit& limit);

/// Returns the noise floor of several records together, the weighted root mean square of their floors.
double commonFloor(const std::vector<double>& floors, const std::vector<gap::PreparedRecord>& records);

}  // namespace rubber_suspension::diagnosis::hypotheses
