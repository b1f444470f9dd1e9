// Numbers of the report, from the judged search: gaps, intervals, the places of the gap, and the gap of each candidate.
#pragma once

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/prepare/log_survey.h"
#include "diagnosis/results/taken_out.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::results {

/// Returns the numbers of a judged search, without sentences and the next experiment. `recorded`: the logs of the gaps
/// as recorded; `raw`: channels of each record; `findings`: errors of the rig from single samples.
Diagnosis describe(const hypotheses::PreparedCase& prepared, Workings judged,
                   const std::vector<prepare::LogSurvey>& recorded, const std::vector<prepare::RawChannels>& raw,
                   std::vector<measurement::RigFinding> findings, const DiagnosisOptions& options);

}  // namespace rubber_suspension::diagnosis::results
