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

/// Even steps for a log. They are those of the log itself, by their mean, where none differs from the median by more
/// than the jitter allowed; else the median, or so much more that there are no more than twice as many samples as in
/// the log, or 20,000. A step longer than half a second and than 20 times that of nine in ten samples is a time gap: no
/// even steps lead across it, they begin again behind it.
struct EvenSteps {
  static constexpr std::size_t kUnknown = std::numeric_limits<std::size_t>::max();

  double dt = 0.0;                ///< [s]
  std::size_t samples = 0;        ///< at these steps; kUnknown where there are time gaps
  bool as_recorded = true;        ///< the log has them itself
  double median = 0.0;            ///< step of the log [s]
  double worst = 0.0;             ///< the one farthest from it that is no time gap [s]
  double duration = 0.0;          ///< without time gaps [s]
  std::size_t gaps = 0;           ///< time gaps
  std::int64_t longest_step = 0;  ///< [ns]; what is longer is a time gap
};

/// The time steps of a log, counted as they come. Memory: some 16,000 different steps, whatever the length; where there
/// are more, near ones count as one.
class TimeSteps {
 public:
  void add(const Log& block);

  std::size_t samples() const { return samples_; }
  std::int64_t firstStamp() const { return first_; }  ///< [ns]
  std::int64_t lastStamp() const { return last_; }

  /// Returns the even steps of two samples or more.
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
  std::int64_t width_ = 1;  // of steps that count as one [ns]
  std::unordered_map<std::int64_t, std::uint64_t> counts_;
};

/// The first samples of the stretches of a log between its time gaps: 0, and those behind a time gap.
std::vector<std::size_t> stretchesOf(const Log& log);

/// The longest of these stretches; the log itself where it has no time gap.
Log longestStretch(const Log& log);

/// A log at even steps, piece by piece.
class EvenBlocks {
 public:
  /// Samples at even steps that follow one another; valid while they are taken. Null where the log has none of a
  /// channel.
  struct Piece {
    double gap;  ///< time since the sample before, where a time gap lies between them [s]; 0: a step
    std::size_t samples;
    const double* displacement;
    const double* force;
    const double* temperature;
    const double* across;
    const double* counts;  ///< as those of the log; null: the force was measured throughout
  };
  using Take = std::function<void(const Piece&)>;

  explicit EvenBlocks(const EvenSteps& steps) : steps_(steps) {}

  /// Hands out what the next block of the log gives.
  void add(const Log& block, const Take& take);

  /// Hands out what the last sample stands for beyond.
  void finish(const Take& take);

 private:
  void interpolate(const Log& left, std::size_t l, const Log& block, std::size_t right);
  void count(bool measured);
  void beginBehindGap(std::int64_t stamp);
  void endStretch(const Log& last, std::size_t sample);
  void handOut(const Take& take);

  EvenSteps steps_;
  std::size_t done_ = 0;  // even steps of the stretch
  bool started_ = false;
  std::int64_t first_stamp_ = 0;  // of the stretch
  double gap_ = 0.0;              // before the piece that is made [s]
  Log last_;                      // the last sample of the blocks before
  Log even_;
};

}  // namespace rubber_suspension::log
