// Even time steps of a log that is read block by block, or as a whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {

/// The even steps of a log. They are the mean step of the log if each step differs from the median step by at most 2 %
/// of the median. Otherwise they are the median step, or a longer one if there would be more than 20,000 samples and
/// more than twice as many as in the log. A step longer than both 0.5 s and 20 times the 90th percentile is a time gap.
struct EvenSteps {
  static constexpr std::size_t kUnknown = std::numeric_limits<std::size_t>::max();

  double dt = 0.0;                ///< [s]
  std::size_t samples = 0;        ///< number of samples at these steps; kUnknown if there are time gaps
  bool as_recorded = true;        ///< true if the steps of the log itself are even
  double median = 0.0;            ///< median step of the log [s]
  double worst = 0.0;             ///< the step, other than a time gap, that differs most from the median [s]
  double duration = 0.0;          ///< duration of the log without its time gaps [s]
  std::size_t gaps = 0;           ///< number of time gaps
  std::int64_t longest_step = 0;  ///< [ns]; a longer step is a time gap
};

/// Counts the time steps of a log by length. If there are more than 16,384 lengths, similar ones are counted as one.
class TimeSteps {
 public:
  void add(const Log& block);

  std::size_t samples() const { return samples_; }
  std::int64_t firstStamp() const { return first_; }  ///< [ns]
  std::int64_t lastStamp() const { return last_; }

  /// Returns the even steps of the log, which needs at least two samples.
  EvenSteps evenSteps() const;

 private:
  void count(std::int64_t step);
  void widen();
  std::vector<std::pair<std::int64_t, std::uint64_t>> ascending() const;

  std::size_t samples_ = 0;
  std::int64_t first_ = 0;
  std::int64_t last_ = 0;
  std::int64_t smallest_ = 0;
  std::int64_t largest_ = 0;
  std::int64_t width_ = 1;  // range of lengths that are counted as one [ns]
  std::unordered_map<std::int64_t, std::uint64_t> counts_;
};

/// Returns the index of the first sample of each stretch of a log. Time gaps separate the stretches.
std::vector<std::size_t> stretchesOf(const Log& log);

/// Returns the longest stretch without a time gap.
Log longestStretch(const Log& log);

/// Resamples a log to even steps, block by block.
class EvenBlocks {
 public:
  /// Consecutive samples at even steps, valid during the call. The pointer of a channel that the log lacks is null.
  struct Piece {
    double gap;  ///< duration of the time gap before these samples [s]; 0 if there is none
    std::size_t samples;
    const double* displacement;
    const double* force;
    const double* temperature;
    const double* across;
    const double* counts;  ///< as Log::counts; null if every force was measured
  };
  using Take = std::function<void(const Piece&)>;

  explicit EvenBlocks(const EvenSteps& steps) : steps_(steps) {}

  /// Passes the resampled samples of the next block to `take`.
  void add(const Log& block, const Take& take);

  /// Passes the remaining resampled samples to `take` at the end of the log.
  void finish(const Take& take);

 private:
  void interpolate(const Log& left, std::size_t l, const Log& block, std::size_t right);
  void count(bool measured);
  void beginBehindGap(std::int64_t stamp);
  void endStretch(const Log& last, std::size_t sample);
  void handOut(const Take& take);

  EvenSteps steps_;
  std::size_t done_ = 0;  // number of even samples of the present stretch so far
  bool started_ = false;
  std::int64_t first_stamp_ = 0;  // first stamp of the present stretch
  double gap_ = 0.0;              // time gap before the next piece [s]
  Log last_;                      // the last sample of the preceding block
  Log even_;
};

}  // namespace rubber_suspension::log
