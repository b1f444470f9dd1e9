// Even time steps of a log that is read block by block, or as a whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {

/// Even steps for a log.
struct EvenSteps {
  double dt = 0.0;          ///< [s]
  std::size_t samples = 0;  ///< at these steps
  bool as_recorded = true;  ///< the log has them itself
};

/// Even steps for a log of so many samples over a duration: their mean step where none differs from the median by more
/// than the jitter allowed, else the median. All times in s.
EvenSteps evenStepsFor(double median, double largest_difference, double duration, std::size_t samples);

/// The time steps of a log, counted as they come. Memory: some 16,000 different steps, whatever the length; where there
/// are more, near ones count as one.
class TimeSteps {
 public:
  void add(const Log& block);

  std::size_t samples() const { return samples_; }
  std::int64_t firstStamp() const { return first_; }  ///< [ns]
  std::int64_t lastStamp() const { return last_; }

  /// Of two samples or more.
  EvenSteps evenSteps() const;

 private:
  void count(std::int64_t step);
  void widen();
  double median() const;

  std::size_t samples_ = 0;
  std::int64_t first_ = 0;
  std::int64_t last_ = 0;
  std::int64_t smallest_ = 0;
  std::int64_t largest_ = 0;
  std::int64_t width_ = 1;  // of steps that count as one [ns]
  std::unordered_map<std::int64_t, std::uint64_t> counts_;
};

/// A log at even steps, piece by piece.
class EvenBlocks {
 public:
  /// Samples at even steps that follow one another; valid until the next block. No temperature where the log has none.
  struct Piece {
    std::size_t samples;
    const double* displacement;
    const double* force;
    const double* temperature;
  };

  explicit EvenBlocks(const EvenSteps& steps) : steps_(steps) {}

  /// What the next block of the log gives. Both together with finish() give as many samples as there are even steps.
  Piece add(const Log& block);

  /// What the last sample stands for beyond.
  Piece finish();

 private:
  void keepLast(const Log& block);
  Piece interpolated() const;

  EvenSteps steps_;
  std::size_t done_ = 0;  // even steps
  std::size_t seen_ = 0;  // samples of the log
  std::int64_t first_stamp_ = 0;
  Log last_;  // the last sample of the blocks before
  Log even_;
};

}  // namespace rubber_suspension::log
