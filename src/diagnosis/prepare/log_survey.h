// A survey of a log, before a diagnosis takes any of it.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "log/even_blocks.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/log/log_source.h"

namespace rubber_suspension::diagnosis::prepare {

/// Moments and extremes of the displacement over stretches of equal length, which grows with the log: there are never
/// more than 65,536 of them.
class MotionSurvey {
 public:
  void add(const std::vector<double>& displacement);

  std::size_t samples() const { return samples_; }

  /// Samples of a stretch, but of the last, which may have fewer.
  std::size_t stretch() const { return length_; }

  /// Standard deviation over the samples from `first` up to `last`, both on ends of stretches [m].
  double deviation(std::size_t first, std::size_t last) const;

  /// The first sample of the first stretch that holds the largest displacement, to whatever side.
  std::size_t largest() const;

  /// Samples of a cycle, by how often the displacement goes from one side of its mean to the other; not fewer than a
  /// stretch, within which two crossings are seen at most.
  double samplesPerCycle() const;

 private:
  struct Stretch {
    double count = 0.0;
    double mean = 0.0;
    double squares = 0.0;  // about the mean
    double low = 0.0;
    double high = 0.0;
    bool low_first = false;
  };

  static Stretch joined(const Stretch& a, const Stretch& b);
  static void extend(Stretch& stretch, double z);
  void halve();
  Stretch moments(std::size_t first, std::size_t last) const;

  std::size_t samples_ = 0;
  std::size_t length_ = 1;
  std::vector<Stretch> stretches_;
};

/// A log that was read once.
struct LogSurvey {
  std::shared_ptr<const log::LogSource> source;
  std::vector<std::string> notes;
  bool has_temperature = false;
  MotionSurvey motion;
  log::TimeSteps steps;

  std::size_t samples() const { return motion.samples(); }
  double duration() const;  ///< [s]
};

/// Reads a log and keeps next to nothing of it. Throws LogError where it cannot be read, and where it has a temperature
/// at which the component's shifts do not hold.
LogSurvey surveyLog(std::shared_ptr<const log::LogSource> source, const component::Component& component);

/// Surveys all logs, several at a time.
std::vector<LogSurvey> surveyLogs(const log::LogSources& sources, const component::Component& component, int threads);

/// Reads a surveyed log again. Throws LogError where it is no longer what it was.
void readAgain(const LogSurvey& survey, const log::LogSource::Take& take);

}  // namespace rubber_suspension::diagnosis::prepare
