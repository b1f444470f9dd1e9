// A survey of a log, before a diagnosis takes any of it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "diagnosis/prepare/motion_survey.h"
#include "log/even_blocks.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/log/log_source.h"

namespace rubber_suspension::diagnosis::prepare {

/// A log that was read once.
struct LogSurvey {
  std::shared_ptr<const log::LogSource> source;
  std::vector<std::string> notes;
  MotionSurvey motion;
  log::TimeSteps steps;

  std::size_t samples() const { return motion.samples(); }
  double duration() const;  ///< [s]
};

/// Reads a log and keeps next to nothing of it. Throws LogError where it cannot be read, and where it has a temperature
/// at which the component's shifts do not hold.
LogSurvey surveyLog(std::shared_ptr<const log::LogSource> source, const component::Component& component);

/// As surveyLog(), of each, several at a time.
std::vector<LogSurvey> surveyLogs(const log::LogSources& sources, const component::Component& component, int threads);

/// Reads a surveyed log again. Throws LogError where it is no longer what it was.
void readAgain(const LogSurvey& survey, const log::LogSource::Take& take);

}  // namespace rubber_suspension::diagnosis::prepare
