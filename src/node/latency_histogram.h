// Histogram of latencies. Its size is fixed, so that counting allocates nothing and takes a few nanoseconds.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>

namespace rubber_suspension::node {

/// Histogram of durations [ns] with eight buckets per octave, so that a percentile is accurate to 9 %.
class LatencyHistogram {
 public:
  std::uint64_t count() const { return count_; }
  double maximum() const { return 1e-9 * static_cast<double>(maximum_); }  ///< [s]

  /// Returns the upper edge [s] of the bucket that contains the percentile of a fraction (0 to 1); 0 without samples.
  double percentile(double fraction) const {
    const double wanted = std::max(1.0, std::ceil(fraction * static_cast<double>(count_)));
    double seen = 0.0;
    double octaves = 0.0;
    for (std::size_t bucket = 0; bucket < buckets_.size() && seen < wanted; ++bucket) {
      seen += buckets_[bucket];
      octaves = static_cast<double>(bucket + 1) / kPerOctave;
    }
    return count_ == 0 ? 0.0 : 1e-9 * std::exp2(octaves);
  }

 private:
  static constexpr double kPerOctave = 8.0;
  static constexpr std::size_t kBuckets = 320;  // up to 2^40 ns, 18 minutes

  friend class LatencyCounter;

  std::array<std::uint32_t, kBuckets> buckets_{};
  std::uint64_t count_ = 0;
  std::int64_t maximum_ = 0;
};

/// Counts durations from any number of threads, without a lock.
class LatencyCounter {
 public:
  void add(std::int64_t nanoseconds) {
    const double octaves = std::log2(static_cast<double>(std::max<std::int64_t>(nanoseconds, 1)));
    const auto bucket = static_cast<std::size_t>(LatencyHistogram::kPerOctave * octaves);
    ++buckets_[std::min(bucket, buckets_.size() - 1)];
    for (std::int64_t longest = maximum_; longest < nanoseconds;) {
      maximum_.compare_exchange_weak(longest, nanoseconds);
    }
  }

  LatencyHistogram take() {
    LatencyHistogram result;
    for (std::size_t bucket = 0; bucket < buckets_.size(); ++bucket) {
      result.buckets_[bucket] = buckets_[bucket].exchange(0);
      result.count_ += result.buckets_[bucket];
    }
    result.maximum_ = maximum_.exchange(0);
    return result;
  }

 private:
  std::array<std::atomic<std::uint32_t>, LatencyHistogram::kBuckets> buckets_{};
  std::atomic<std::int64_t> maximum_{0};
};

}  // namespace rubber_suspension::node
