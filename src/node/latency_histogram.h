// How long samples took, as a histogram of fixed size: counting one allocates nothing and costs some nanoseconds.
#pragma once

#include <array>
#include <cstdint>

namespace rubber_suspension::node {

/// Durations in nanoseconds, in buckets that are eight to an octave: a percentile is exact to 12.5 %.
class LatencyHistogram {
 public:
  void add(std::int64_t nanoseconds);
  void clear();

  std::uint64_t count() const { return count_; }
  double maximum() const { return 1e-9 * static_cast<double>(maximum_); }  ///< [s]
  double mean() const;                                                     ///< [s]; 0 without samples

  /// Upper edge of the bucket below which this fraction (0 to 1) of the samples lies [s]; 0 without samples.
  double percentile(double fraction) const;

 private:
  static constexpr int kBucketsPerOctave = 8;
  static constexpr int kBuckets = 40 * kBucketsPerOctave;  // up to 2^40 ns, 18 minutes

  static int bucketOf(std::int64_t nanoseconds);
  static double upperEdge(int bucket);

  std::array<std::uint32_t, kBuckets> buckets_{};
  std::uint64_t count_ = 0;
  std::int64_t sum_ = 0;
  std::int64_t maximum_ = 0;
};

}  // namespace rubber_suspension::node
