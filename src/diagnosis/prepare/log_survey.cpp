// A survey of a log, before a diagnosis takes any of it.
#include "diagnosis/prepare/log_survey.h"

#include <fmt/format.h>

#include <utility>

#include "fit/parallel.h"
#include "log/samples.h"
#include "rubber_suspension/gap/replay.h"

namespace rubber_suspension::diagnosis::prepare {

double LogSurvey::duration() const { return static_cast<double>(steps.lastStamp() - steps.firstStamp()) * 1e-9; }

LogSurvey surveyLog(std::shared_ptr<const log::LogSource> source, const component::Component& component) {
  LogSurvey survey;
  survey.notes = source->read([&](const log::Log& block, std::size_t first) {
    gap::checkTemperature(component, block, first);
    survey.motion.add(block.displacement);
    survey.steps.add(block);
    return true;
  });
  survey.source = std::move(source);
  return survey;
}

std::vector<LogSurvey> surveyLogs(const log::LogSources& sources, const component::Component& component, int threads) {
  std::vector<LogSurvey> surveys(sources.size());
  fit::parallelFor(sources.size(), threads, [&](std::size_t i) { surveys[i] = surveyLog(sources[i], component); });
  return surveys;
}

// A recorder that still writes makes a log longer, which does no harm: what was there is taken.
void readAgain(const LogSurvey& survey, const log::LogSource::Take& take) {
  std::size_t seen = 0;
  bool ended = false;
  survey.source->read([&](const log::Log& block, std::size_t first) {
    const std::size_t left = survey.samples() - first;
    seen = first + block.size();
    if (seen < survey.samples()) {
      ended = !take(block, first);
      return !ended;
    }
    take(seen == survey.samples() ? block : log::samplesOf(block, 0, left), first);
    ended = true;
    return false;
  });
  if (!ended) {
    throw log::LogError(
        fmt::format("{}: {} samples, and {} a moment ago; accepted: a file that nobody changes meanwhile",
                    survey.source->name(), seen, survey.samples()));
  }
}

}  // namespace rubber_suspension::diagnosis::prepare
