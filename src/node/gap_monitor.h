// Matches measured to simulated forces by stamp and keeps the last seconds of them, for the live gap. Knows no ROS.
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <vector>

namespace rubber_suspension::node {

/// A displacement with simulated and measured force at one stamp.
struct MatchedSample {
  std::int64_t stamp = 0;     ///< [ns]
  double displacement = 0.0;  ///< [m]
  double simulated = 0.0;     ///< [N]
  double measured = 0.0;      ///< [N]; NaN until it has come
};

struct MatchCounters {
  std::uint64_t matched = 0;
  std::uint64_t unmatched = 0;   ///< measured forces whose stamp no sample had, or had no more
  std::uint64_t not_finite = 0;  ///< measured forces dropped
};

/// Takes samples and measured forces from different threads, in any order to each other, late or early. Costs nothing
/// until the first measured force comes; from then on it allocates nothing and holds its lock for one sample's time.
class GapMonitor {
 public:
  static constexpr std::size_t kCapacity = 32768;  ///< samples kept: 32 s at 1 kHz, 3 s at 10 kHz
  static constexpr std::size_t kWaiting = 4096;    ///< measured forces ahead of their samples, kept at most

  /// A sample that the component accepted. A stamp that steps back is a new replay: all earlier samples are forgotten.
  void addSimulated(std::int64_t stamp, double displacement, double force);

  /// Returns false where the force is not finite.
  bool addMeasured(std::int64_t stamp, double force);

  /// Forget all samples; counters stay.
  void clear();

  /// The matched samples of the last `window` [s], in order. Takes the lock piece by piece, so that nobody waits long.
  std::vector<MatchedSample> window(double window) const;

  MatchCounters counters() const;

 private:
  struct Waiting {
    std::int64_t stamp;
    double force;
  };

  MatchedSample& at(std::uint64_t number) { return samples_[number % kCapacity]; }
  const MatchedSample& at(std::uint64_t number) const { return samples_[number % kCapacity]; }
  std::uint64_t oldest() const { return count_ > kCapacity + first_ ? count_ - kCapacity : first_; }
  MatchedSample* find(std::int64_t stamp);
  void match(MatchedSample& sample, double force);
  void takeWaiting(MatchedSample& sample);
  void forget();

  mutable std::mutex mutex_;
  std::atomic<bool> wanted_{false};
  std::vector<MatchedSample> samples_;  // a ring; sample number n lies at n modulo its size
  std::uint64_t first_ = 0;             // number of the first sample since the last restart
  std::uint64_t count_ = 0;             // number of the next sample
  std::vector<Waiting> waiting_;
  MatchCounters counters_;
};

}  // namespace rubber_suspension::node
