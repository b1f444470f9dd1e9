// The report's numbers: gaps and intervals, where the gap lies, what each candidate would do. After the judgement,
// once.
#pragma once

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/prepare/log_survey.h"
#include "diagnosis/results/taken_out.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::results {

/// The numbers of a search and its judgement; words and the next experiment are still to be found. `recorded`: the logs
/// that the gaps are of with all that the rig did to them; `raw`: of each record; `findings`: what single samples of
/// the logs told.
Diagnosis describe(const hypotheses::PreparedCase& prepared, Workings judged,
                   const std::vector<prepare::LogSurvey>& recorded, const std::vector<prepare::RawChannels>& raw,
                   std::vector<measurement::RigFinding> findings, const DiagnosisOptions& options);

}  // namespace rubber_suspension::diagnosis::results
