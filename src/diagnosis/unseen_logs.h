// What fitted hypotheses say of logs that took no part in the fit.
#pragma once

#include <vector>

#include "diagnosis/judge/evidence.h"
#include "diagnosis/search.h"
#include "fit/model_parameters.h"
#include "gap/simulate.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::diagnosis {

/// Gaps of a fitted hypothesis over records, each of them recorded on a new component.
UnseenErrors unseenErrors(const fit::ModelParameters& model, const FittedHypothesis& fitted,
                          const std::vector<log::Record>& records, double loudest);

/// Noise floor of each record, by what a component leaves of its force: no more than `loudest` [N], since all logs come
/// from one rig and what a model lacks on a log that it was not fitted to must not pass for noise.
std::vector<double> noiseFloors(const std::vector<element::ElementDescription>& elements, const gap::Forces& simulated,
                                const std::vector<log::Record>& records, double loudest);

/// That limit from the floors of the logs of the fit, which are gaps.
double loudestNoise(const std::vector<double>& floors, const std::vector<log::Record>& records);

/// Floor of several records, which count alike.
double commonFloor(const std::vector<double>& floors);

}  // namespace rubber_suspension::diagnosis
