// First pass over a log, which finds its motion and time steps before a diagnosis selects samples.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "log/even_blocks.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/log/log_source.h"

namespace rubber_suspension::diagnosis::prepare {

/// Moments and extremes of the displacement over stretches of equal length, which doubles as the log grows, so that
/// there are at most 65,536 stretches.
class MotionSurvey {
 public:
  void add(const std::vector<double>& displacement);

  std::size_t samples() const { return samples_; }

  /// Returns the number of samples in a stretch; the last stretch may have fewer.
  std::size_t stretch() const { return length_; }

  /// Returns the standard deviation [m] over the samples [first, last), both at limits of stretches.
  double deviation(std::size_t first, std::size_t last) const;

  /// Returns the first sample of the first stretch that contains the displacement of largest magnitude.
  std::size_t largest() const;

  /// Returns the mean number of samples per cycle, from the crossings of the mean. It is at least stretch(), because at
  /// most two crossings per stretch are counted.
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

/// Results of the first pass over a log.
struct LogSurvey {
  std::shared_ptr<const log::LogSource> source;
  std::vector<std::string> notes;
  bool has_temperature = false;
  MotionSurvey motion;
  log::TimeSteps steps;

  std::size_t samples() const { return motion.samples(); }
  double duration() const;  ///< [s]
};

/// Surveys a log in bounded memory. Throws LogError if it cannot be read, or has a temperature for which the
/// component's temperature shifts do not hold.
LogSurvey surveyLog(std::shared_ptr<const log::LogSource> source, const component::Component& component);

/// Surveys all logs, in up to `threads` threads.
std::vector<LogSurvey> surveyLogs(const log::LogSources& sources, const component::Component& component, int threads);

/// Reads the samples of a surveyed log again. Throws LogError if it has fewer of them than before.
void readAgain(const LogSurvey& survey, const log::LogSource::Take& take);

}  // namespace rubber_suspension::diagnosis::prepare
