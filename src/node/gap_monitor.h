// Matches measured to simulated forces by stamp, and stores the last seconds for the live gap. Independent of ROS.
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

struct MatchedSample {
  std::int64_t stamp = 0;                                    ///< [ns]
  double displacement = 0.0;                                 ///< [m]
  double simulated = 0.0;                                    ///< [N]
  double measured = 0.0;                                     ///< [N]; NaN until the measured force is received
  double beside = std::numeric_limits<double>::quiet_NaN();  ///< force of the second model [N], if any
};

struct MatchCounters {
  std::uint64_t matched = 0;
  std::uint64_t unmatched = 0;   ///< number of measured forces without a stored sample of the same stamp
  std::uint64_t not_finite = 0;  ///< number of measured forces not finite or beyond element::kLargestNumber
};

/// Matches samples and measured forces, which may come from different threads in any order. Does nothing before the
/// first measured force. Then locks for one sample at a time, and allocates only beyond kCapacity.
class GapMonitor {
 public:
  static constexpr std::size_t kCapacity = 32768;  ///< samples stored by default: 32 s at 1 kHz, 3 s at 10 kHz
  static constexpr std::size_t kWaiting = 4096;    ///< largest number of measured forces that wait for their samples

  /// Stores `capacity` samples, at least kCapacity. Memory for samples beyond kCapacity is allocated when they come.
  explicit GapMonitor(std::size_t capacity = kCapacity);

  /// Adds an accepted sample with stamp [ns], displacement [m] and force [N]. A stamp that is not later than the last
  /// one begins a new replay and discards all earlier samples. Samples with numbers beyond element::kLargestNumber are
  /// ignored. `beside` is the force [N] of the second model, if any.
  void addSimulated(std::int64_t stamp, double displacement, double force,
                    double beside = std::numeric_limits<double>::quiet_NaN());

  /// Adds a measured force [N] with a stamp [ns]. Returns false if it is not finite or beyond element::kLargestNumber.
  bool addMeasured(std::int64_t stamp, double force);

  void clear();

  /// Returns the matched samples of the last `window` [s], in order.
  std::vector<MatchedSample> window(double window) const;

  /// Returns about `most` matched samples at most, in order, from sample number `next` on, and advances `next` past
  /// them. Samples that were overwritten before the call are missing. The lock is released after each piece, so that
  /// other threads do not wait long.
  std::vector<MatchedSample> read(std::uint64_t& next, std::size_t most) const;

  MatchCounters counters() const;

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
  std::vector<std::unique_ptr<Block>> blocks_;  // a ring buffer: sample number n is at n modulo the capacity
  std::uint64_t first_ = 0;                     // number of the first sample since the last restart
  std::uint64_t count_ = 0;                     // number of the next sample
  std::uint64_t matched_end_ = 0;               // number after the newest matched sample
  std::vector<Waiting> waiting_;
  MatchCounters counters_;
  PairedErrors paired_;
};

}  // namespace rubber_suspension::node
