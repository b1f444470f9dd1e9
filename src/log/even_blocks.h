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

/// Even steps for a log: its own mean step if no step differs from the median by more than the jitter allowed; else the
/// median, or a longer step if there would be more than 20,000 samples and than twice those of the log. A step longer
/// than half a second and than 20 times the 90th percentile of the steps is a time gap, behind which even steps begin
/// again.
struct EvenSteps {
  static constexpr std::size_t kUnknown = std::numeric_limits<std::size_t>::max();

  double dt = 0.0;                ///< [s]
  std::size_t samples = 0;        ///< at these steps; kUnknown if there are time gaps
  bool as_recorded = true;        ///< the log itself has even steps
  double median = 0.0;            ///< step of the log [s]
  double worst = 0.0;             ///< step farthest from the median that is no time gap [s]
  double duration = 0.0;          ///< without time gaps [s]
  std::size_t gaps = 0;           ///< number of time gaps
  std::int64_t longest_step = 0;  ///< [ns]; a longer step is a time gap
};

/// Counts the time steps of a log. Memory: some 16,000 different steps, whatever the length; if there are more, similar
/// ones count as one.
class TimeSteps {
 public:
  void add(const Log& block);

  std::size_t samples() const { return samples_; }
  std::int64_t firstStamp() const { return first_; }  ///< [ns]
  std::int64_t lastStamp() const { return last_; }

  /// Returns the even steps of a log of at least two samples.
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
  std::int64_t width_ = 1;  // range of steps that count as one [ns]
  std::unordered_map<std::int64_t, std::uint64_t> counts_;
};

/// Returns the first samples of the stretches of a log between its time gaps: 0, and those behind a time gap.
std::vector<std::size_t> stretchesOf(const Log& log);

/// Returns the longest of these stretches; the log itself if it has no time gap.
Log longestStretch(const Log& log);

/// Resamples a log to even steps, block by block.
class EvenBlocks {
 public:
  /// Consecutive samples at even steps, valid during the call. Channels that the log lacks are null.
  struct Piece {
    double gap;  ///< time since the preceding sample if a time gap lies between them [s]; 0: a step
    std::size_t samples;
    const double* displacement;
    const double* force;
    const double* temperature;
    const double* across;
    const double* counts;  ///< as Log::counts; null: the force was measured throughout
  };
  using Take = std::function<void(const Piece&)>;

  explicit EvenBlocks(const EvenSteps& steps) : steps_(steps) {}

  /// Passes on the even samples of the next block.
  void add(const Log& block, const Take& take);

  /// Passes on the even samples that remain at the end of the log.
  void finish(const Take& take);

 private:
  void interpolate(const Log& left, std::size_t l, const Log& block, std::size_t right);
  void count(bool measured);
  void beginBehindGap(std::int64_t stamp);
  void endStretch(const Log& last, std::size_t sample);
  void handOut(const Take& take);

  EvenSteps steps_;
  std::size_t done_ = 0;  // even steps of the stretch so far
  bool started_ = false;
  std::int64_t first_stamp_ = 0;  // of the stretch
  double gap_ = 0.0;              // before the next piece [s]
  Log last_;                      // last sample of the preceding block
  Log even_;
};

}  // namespace rubber_suspension::log
