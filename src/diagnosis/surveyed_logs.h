// A diagnosis in two steps: a first reading of the logs, which returns their notes, and the search.
#pragma once

#include <vector>

#include "diagnosis/prepare/log_survey.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// Logs of a diagnosis that were read once.
struct SurveyedLogs {
  std::vector<prepare::LogSurvey> logs;
  std::vector<prepare::LogSurvey> hold_out;
};

/// Reads the logs for the first time. Throws LogError where there is none, and as prepare::surveyLog() does;
/// std::invalid_argument for a component that cannot be built.
SurveyedLogs surveyed(const io::ComponentDescription& component, const log::LogSources& logs,
                      const log::LogSources& hold_out, int threads);

/// As diagnose() of the logs themselves.
Diagnosis diagnose(const io::ComponentDescription& component, const SurveyedLogs& logs,
                   const DiagnosisOptions& options);

}  // namespace rubber_suspension::diagnosis
