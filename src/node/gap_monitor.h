// Matches measured to simulated forces by stamp and keeps the last seconds of them, for the live gap. Independent of
// ROS.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

#include "node/promotion.h"

namespace rubber_suspension::node {

/// A displacement with simulated and measured force at one stamp.
struct MatchedSample {
  std::int64_t stamp = 0;                                    ///< [ns]
  double displacement = 0.0;                                 ///< [m]
  double simulated = 0.0;                                    ///< [N]
  double measured = 0.0;                                     ///< [N]; NaN until it has come
  double beside = std::numeric_limits<double>::quiet_NaN();  ///< [N] of the model beside the published one, if any
};

struct MatchCounters {
  std::uint64_t matched = 0;
  std::uint64_t unmatched = 0;   ///< measured forces whose stamp no sample had, or had no more
  std::uint64_t not_finite = 0;  ///< measured forces dropped, those beyond element::kLargestNumber among them
};

/// Matches samples and measured forces from different threads, in any relative order. Costs nothing before the first
/// measured force; afterwards it allocates nothing and locks for one sample at a time.
class GapMonitor {
 public:
  static constexpr std::size_t kCapacity = 32768;  ///< samples kept by default: 32 s at 1 kHz, 3 s at 10 kHz
  static constexpr std::size_t kWaiting = 4096;    ///< measured forces ahead of their samples, kept at most

  /// Stores `capacity` samples, at least kCapacity; memory beyond that is allocated as they come.
  explicit GapMonitor(std::size_t capacity = kCapacity);

  /// A sample that the component accepted. A stamp that steps back is a new replay: all earlier samples are forgotten.
  /// One beyond element::kLargestNumber is passed over. `beside` is the force [N] of a model that is computed beside
  /// the published one, if any.
  void addSimulated(std::int64_t stamp, double displacement, double force,
                    double beside = std::numeric_limits<double>::quiet_NaN());

  /// Returns false where the force is not finite, or beyond element::kLargestNumber.
  bool addMeasured(std::int64_t stamp, double force);

  /// Forget all samples; counters stay.
  void clear();

  /// The matched samples of the last `window` [s], in order.
  std::vector<MatchedSample> window(double window) const;

  /// The matched samples from number `next` on, in order, about `most` at most; moves `next` behind them. A reader that
  /// comes too late misses what was overwritten. Takes the lock piece by piece, so that nobody waits long.
  std::vector<MatchedSample> read(std::uint64_t& next, std::size_t most) const;

  MatchCounters counters() const;

  /// Errors of the published force and of the one beside it, since they were cleared.
  PairedErrors pairedErrors() const;
  void clearPairedErrors();

 private:
  struct Waiting {
    std::int64_t stamp;
    double force;
  };

  static constexpr std::size_t kBlock = 4096;  // samples
  using Block = std::array<MatchedSample, kBlock>;

  MatchedSample& at(std::uint64_t number) const {
    const std::uint64_t place = number % capacity_;
    return (*blocks_[place / kBlock])[place % kBlock];
  }
  void makeRoom(std::uint64_t number);
  std::uint64_t oldest() const { return count_ > capacity_ + first_ ? count_ - capacity_ : first_; }
  std::uint64_t firstFrom(std::int64_t stamp) const;
  void match(std::uint64_t number, double force);
  void takeWaiting(std::uint64_t number);

  const std::size_t capacity_;
  mutable std::mutex mutex_;
  std::atomic<bool> wanted_{false};
  std::vector<std::unique_ptr<Block>> blocks_;  // of a ring; sample number n is at n modulo the capacity
  std::uint64_t first_ = 0;                     // number of the first sample since the last restart
  std::uint64_t count_ = 0;                     // number of the next sample
  std::uint64_t matched_end_ = 0;               // number behind the newest that is matched
  std::vector<Waiting> waiting_;
  MatchCounters counters_;
  PairedErrors paired_;
};

}  // namespace rubber_suspension::node
