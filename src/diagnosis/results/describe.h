// Computes the numbers of a report from a judged search: gaps, their intervals, and where in the logs the gap lies.
#pragma once

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/prepare/log_survey.h"
#include "diagnosis/results/taken_out.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::results {

/// Returns the numbers of a judged search, without sentences and the next experiment. `recorded` are the logs for gaps
/// as recorded, `raw` the channels of each record, and `findings` the errors of the rig that single samples have shown.
Diagnosis describe(const hypotheses::PreparedCase& prepared, Workings judged,
                   const std::vector<prepare::LogSurvey>& recorded, const std::vector<prepare::RawChannels>& raw,
                   std::vector<measurement::RigFinding> findings, const DiagnosisOptions& options);

}  // namespace rubber_suspension::diagnosis::results
