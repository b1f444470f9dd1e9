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

/// Errors of parts of logs that took no part in the fit, by what a fitted hypothesis predicts from the displacement
/// smoothed as for the fits, since the noise of that sensor is the rig's.
using UnseenErrors = std::vector<gap::PartError>;

/// Force of a fitted hypothesis over records, each of them recorded on a new component [N], from the displacement
/// smoothed as for the fits: the noise of its sensor is the rig's.
gap::Forces predict(const fit::ModelParameters& model, const FittedHypothesis& fitted,
                    const std::vector<gap::PreparedRecord>& records);

/// Errors of a fitted hypothesis on records, each from a new component.
UnseenErrors unseenErrors(const fit::ModelParameters& model, const FittedHypothesis& fitted,
                          const std::vector<gap::PreparedRecord>& records);

/// Errors of forces predicted by elements, with the per-log unknowns of a hypothesis.
UnseenErrors unseenErrors(fit::Hypothesis hypothesis, const std::vector<element::ElementDescription>& elements,
                          const gap::Forces& predicted, const std::vector<gap::PreparedRecord>& records);

/// The friction of a component on each record, each of them recorded on a new one (fit::frictionOf()).
fit::ForceColumn frictionOfEach(const std::vector<element::ElementDescription>& elements,
                                const std::vector<gap::PreparedRecord>& records);

/// Errors of tenths of each record (gap::partErrors()) under a hypothesis: without what it has free in each log, which
/// no simulation predicts, as far as the other tenths of the log tell it.
std::vector<gap::PartError> partErrorsOf(const fit::Hypothesis& hypothesis,
                                         const std::vector<gap::PreparedRecord>& records, const gap::Forces& simulated);

/// The mean error of each log; `otherwise` where no part of a log has any weight.
std::vector<double> errorsByLog(const std::vector<gap::PartError>& parts, std::vector<double> otherwise);

/// The part of it that is free in a noise floor: zeros and gains, which are no noise. Trends take slow noise with them.
fit::PerLogNuisances freeOfNoise(const fit::Hypothesis& hypothesis);

/// Noise floor of each record, by what a component leaves of its force, up to a limit; without what is free in each
/// log.
std::vector<double> noiseFloors(const std::vector<element::ElementDescription>& elements,
                                const fit::PerLogNuisances& free, const gap::Forces& simulated,
                                const std::vector<gap::PreparedRecord>& records, const measurement::NoiseLimit& limit);

/// Floor of several records, each by its weight.
double commonFloor(const std::vector<double>& floors, const std::vector<gap::PreparedRecord>& records);

}  // namespace rubber_suspension::diagnosis::hypotheses
