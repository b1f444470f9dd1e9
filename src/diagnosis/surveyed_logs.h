// The two steps of a diagnosis: a survey of the logs, which returns notes on them, and the search.
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

/// Surveys the logs. Throws LogError if there is no log and for the reasons of prepare::surveyLog(), and throws
/// std::invalid_argument if the component cannot be built.
SurveyedLogs surveyed(const io::ComponentDescription& component, const log::LogSources& logs,
                      const log::LogSources& hold_out, int threads);

/// Diagnoses surveyed logs. The result is that of diagnose() for the sources of these logs.
Diagnosis diagnose(const io::ComponentDescription& component, const SurveyedLogs& logs,
                   const DiagnosisOptions& options);

}  // namespace rubber_suspension::diagnosis
