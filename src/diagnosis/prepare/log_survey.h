// Surveys the motion and the time steps of a log in a first pass, before a diagnosis selects samples.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "log/even_blocks.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/log/log_source.h"

namespace rubber_suspension::diagnosis::prepare {

/// Moments and extremes of the displacement over stretches of equal length. The length doubles as the log grows, so
/// that there are at most 65,536 stretches.
class MotionSurvey {
 public:
  void add(const std::vector<double>& displacement);

  std::size_t samples() const { return samples_; }

  /// Returns the number of samples in a stretch; the last stretch may have fewer.
  std::size_t stretch() const { return length_; }

  /// Returns the standard deviation [m] of the samples [first, last). Both indices have to be limits of stretches.
  double deviation(std::size_t first, std::size_t last) const;

  /// Returns the index of the first sample of the stretch that contains the largest absolute displacement.
  std::size_t largest() const;

  /// Returns the mean number of samples per cycle, computed from the crossings of the mean. The result is at least
  /// stretch(), because at most two crossings per stretch are counted.
  double samplesPerCycle() const;

 private:
  struct Stretch {
    double count = 0.0;
    double mean = 0.0;
    double squares = 0.0;  // sum of the squared deviations from the mean
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

struct LogSurvey {
  std::shared_ptr<const log::LogSource> source;
  std::vector<std::string> notes;
  bool has_temperature = false;
  MotionSurvey motion;
  log::TimeSteps steps;

  std::size_t samples() const { return motion.samples(); }
  double duration() const;  ///< [s]
};

/// Surveys a log in bounded memory. Throws LogError if the log cannot be read, or if it has a temperature outside the
/// range of the component's temperature shifts.
LogSurvey surveyLog(std::shared_ptr<const log::LogSource> source, const component::Component& component);

std::vector<LogSurvey> surveyLogs(const log::LogSources& sources, const component::Component& component, int threads);

/// Reads the samples of a surveyed log again. Throws LogError if the log has become shorter since the survey.
void readAgain(const LogSurvey& survey, const log::LogSource::Take& take);

}  // namespace rubber_suspension::diagnosis::prepare
