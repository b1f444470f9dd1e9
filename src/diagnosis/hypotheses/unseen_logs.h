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

/// Errors of a prediction on parts of logs that took no part in the fit.
using UnseenErrors = std::vector<gap::PartError>;

/// Returns the force of a fitted hypothesis over records, each of a new component [N]. The displacement is smoothed as
/// for the fits, because the noise of its sensor is an error of the rig.
gap::Forces predict(const fit::ModelParameters& model, const FittedHypothesis& fitted,
                    const std::vector<gap::PreparedRecord>& records);

/// Returns the errors of a fitted hypothesis on records, each of a new component.
UnseenErrors unseenErrors(const fit::ModelParameters& model, const FittedHypothesis& fitted,
                          const std::vector<gap::PreparedRecord>& records);

/// Returns the errors of forces that elements predict, without the part that the per-log unknowns of a hypothesis, such
/// as an offset, explain.
UnseenErrors unseenErrors(fit::Hypothesis hypothesis, const std::vector<element::ElementDescription>& elements,
                          const gap::Forces& predicted, const std::vector<gap::PreparedRecord>& records);

/// Returns the friction of a component on records, each of a new component (fit::frictionOf()).
fit::ForceColumn frictionOfEach(const std::vector<element::ElementDescription>& elements,
                                const std::vector<gap::PreparedRecord>& records);

/// Returns the errors of tenths of each record (gap::partErrors()) under a hypothesis. Per-log unknowns, which no
/// simulation predicts, are removed as the other tenths of the log determine them.
std::vector<gap::PartError> partErrorsOf(const fit::Hypothesis& hypothesis,
                                         const std::vector<gap::PreparedRecord>& records, const gap::Forces& simulated);

/// Returns the mean error of each log, or the value of `otherwise` if no part of the log has any weight.
std::vector<double> errorsByLog(const std::vector<gap::PartError>& parts, std::vector<double> otherwise);

/// Returns the per-log unknowns that are removed before a noise floor is estimated: offsets and gains, which are no
/// noise. Trends are not removed, because they would absorb slow noise.
fit::PerLogNuisances freeOfNoise(const fit::Hypothesis& hypothesis);

/// Returns the noise floor of each record: the noise in the residual of a component after removal of `free`, up to a
/// limit, or the error that noise of the displacement causes in its friction, if that is larger.
std::vector<double> noiseFloors(const std::vector<element::ElementDescription>& elements,
                                const fit::PerLogNuisances& free, const gap::Forces& simulated,
                                const std::vector<gap::PreparedRecord>& records, const measurement::NoiseLimit& limit);

/// Returns the floor of several records together: the weighted root mean square.
double commonFloor(const std::vector<double>& floors, const std::vector<gap::PreparedRecord>& records);

}  // namespace rubber_suspension::diagnosis::hypotheses
