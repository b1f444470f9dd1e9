// The gap of logs with all that the rig did to them.
#pragma once

#include <vector>

#include "diagnosis/prepare/log_survey.h"
#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::diagnosis::results {

/// Whether the logs were recorded on one component, which relaxes between them, or each on a new one.
enum class Recorded { on_one_component, each_on_a_new_one };

/// Gap of each of several lists of elements to whole logs as `replay` gives it, at even time steps: the root of the
/// mean over the logs of their squared gaps. Each log is read once, block by block. Throws LogError where a log has no
/// force or is no longer what it was in the survey.
std::vector<double> recordedGaps(const std::vector<std::vector<element::ElementDescription>>& models,
                                 const std::vector<prepare::LogSurvey>& logs, Recorded recorded, int threads);

}  // namespace rubber_suspension::diagnosis::results
