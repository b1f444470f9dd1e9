// Surveys a log in a first pass, before a diagnosis selects samples.
#include "diagnosis/prepare/log_survey.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/parallel.h"
#include "log/samples.h"
#include "rubber_suspension/gap/replay.h"

namespace rubber_suspension::diagnosis::prepare {
namespace {

constexpr std::size_t kMostStretches = 65536;
// Hysteresis of a crossing of the mean, in standard deviations, so that noise is not counted as a crossing.
constexpr double kCrossing = 0.5;

}  // namespace

double LogSurvey::duration() const { return static_cast<double>(steps.lastStamp() - steps.firstStamp()) * 1e-9; }

LogSurvey surveyLog(std::shared_ptr<const log::LogSource> source, const component::Component& component) {
  LogSurvey survey;
  survey.notes = source->read([&](const log::Log& block, std::size_t first) {
    gap::checkTemperature(component, block, first);
    survey.motion.add(block.displacement);
    survey.steps.add(block);
    survey.has_temperature = !block.temperature.empty();
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

// A recorder may still append to the log. Samples that were appended after the survey are ignored.
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
        fmt::format("{}: the file changed while it was read: it has {} samples now and had {} before; accepted: a file "
                    "that does not change",
                    survey.source->name(), seen, survey.samples()));
  }
}

// Combines moments as in Chan, Golub and LeVeque, The American Statistician 37 (1983).
MotionSurvey::Stretch MotionSurvey::joined(const Stretch& a, const Stretch& b) {
  Stretch both;
  both.count = a.count + b.count;
  const double apart = b.mean - a.mean;
  both.mean = a.mean + apart * b.count / both.count;
  both.squares = a.squares + b.squares + apart * apart * a.count * b.count / both.count;
  const bool low_in_a = a.low <= b.low;
  const bool high_in_a = a.high >= b.high;
  both.low = std::min(a.low, b.low);
  both.high = std::max(a.high, b.high);
  both.low_first = low_in_a && high_in_a ? a.low_first : !low_in_a && !high_in_a ? b.low_first : low_in_a;
  return both;
}

void MotionSurvey::extend(Stretch& stretch, double z) { stretch = joined(stretch, {1.0, z, 0.0, z, z, false}); }

void MotionSurvey::halve() {
  for (std::size_t i = 0; i < kMostStretches / 2; ++i) {
    stretches_[i] = joined(stretches_[2 * i], stretches_[2 * i + 1]);
  }
  stretches_.resize(kMostStretches / 2);
  length_ *= 2;
}

void MotionSurvey::add(const std::vector<double>& displacement) {
  for (const double z : displacement) {
    if (samples_ % length_ != 0) {
      extend(stretches_.back(), z);
    } else {
      if (stretches_.size() == kMostStretches) {
        halve();
      }
      stretches_.push_back({1.0, z, 0.0, z, z, false});
    }
    ++samples_;
  }
}

MotionSurvey::Stretch MotionSurvey::moments(std::size_t first, std::size_t last) const {
  const std::size_t end = (last + length_ - 1) / length_;
  Stretch all = stretches_[first / length_];
  for (std::size_t i = first / length_ + 1; i < end; ++i) {
    all = joined(all, stretches_[i]);
  }
  return all;
}

double MotionSurvey::deviation(std::size_t first, std::size_t last) const {
  const Stretch all = moments(first, last);
  return std::sqrt(all.squares / all.count);
}

std::size_t MotionSurvey::largest() const {
  const auto size = [](const Stretch& stretch) { return std::max(-stretch.low, stretch.high); };
  const auto found = std::max_element(stretches_.begin(), stretches_.end(),
                                      [&](const Stretch& a, const Stretch& b) { return size(a) < size(b); });
  return static_cast<std::size_t>(found - stretches_.begin()) * length_;
}

double MotionSurvey::samplesPerCycle() const {
  const Stretch all = moments(0, samples_);
  const double threshold = kCrossing * std::sqrt(all.squares / all.count);
  int side = 0;
  double crossings = 0.0;
  const auto pass = [&](double z) {
    const int now = z - all.mean > threshold ? 1 : z - all.mean < -threshold ? -1 : side;
    crossings += now * side < 0 ? 1.0 : 0.0;
    side = now;
  };
  for (const Stretch& stretch : stretches_) {
    pass(stretch.low_first ? stretch.low : stretch.high);
    pass(stretch.low_first ? stretch.high : stretch.low);
  }
  return 2.0 * static_cast<double>(samples_) / std::max(crossings, 1.0);
}

}  // namespace rubber_suspension::diagnosis::prepare
