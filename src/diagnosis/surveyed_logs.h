// A diagnosis in two steps: a survey of the logs, which returns their notes, and the search.
#pragma once

#include <vector>

#include "diagnosis/prepare/log_survey.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// Logs of a diagnosis that have been read once.
struct SurveyedLogs {
  std::vector<prepare::LogSurvey> logs;
  std::vector<prepare::LogSurvey> hold_out;
};

/// Surveys the logs. Throws LogError if there is none, and like prepare::surveyLog(); std::invalid_argument for a
/// component that cannot be built.
SurveyedLogs surveyed(const io::ComponentDescription& component, const log::LogSources& logs,
                      const log::LogSources& hold_out, int threads);

/// Diagnoses surveyed logs, like diagnose() of their sources.
Diagnosis diagnose(const io::ComponentDescription& component, const SurveyedLogs& logs,
                   const DiagnosisOptions& options);

}  // namespace rubber_suspension::diagnosis
