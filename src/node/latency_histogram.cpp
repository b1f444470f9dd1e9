// How long samples took, as a histogram of fixed size.
#include "node/latency_histogram.h"

#include <algorithm>
#include <cmath>

namespace rubber_suspension::node {

int LatencyHistogram::bucketOf(std::int64_t nanoseconds) {
  if (nanoseconds < kBucketsPerOctave) {
    return nanoseconds < 0 ? 0 : static_cast<int>(nanoseconds);
  }
  // The three bits below the leading one tell the eighth of the octave.
  const int octave = 63 - __builtin_clzll(static_cast<unsigned long long>(nanoseconds));
  const int eighth = static_cast<int>((nanoseconds >> (octave - 3)) & 7);
  return std::min((octave - 2) * kBucketsPerOctave + eighth, kBuckets - 1);
}

double LatencyHistogram::upperEdge(int bucket) {
  if (bucket < kBucketsPerOctave) {
    return 1e-9 * (bucket + 1);
  }
  const int octave = bucket / kBucketsPerOctave + 2;
  const int eighth = bucket % kBucketsPerOctave;
  return 1e-9 * std::ldexp(1.0 + (eighth + 1) / 8.0, octave);
}

void LatencyHistogram::add(std::int64_t nanoseconds) {
  ++buckets_[static_cast<std::size_t>(bucketOf(nanoseconds))];
  ++count_;
  sum_ += nanoseconds;
  maximum_ = std::max(maximum_, nanoseconds);
}

void LatencyHistogram::clear() { *this = LatencyHistogram(); }

double LatencyHistogram::mean() const {
  return count_ == 0 ? 0.0 : 1e-9 * static_cast<double>(sum_) / static_cast<double>(count_);
}

double LatencyHistogram::percentile(double fraction) const {
  if (count_ == 0) {
    return 0.0;
  }
  const double wanted = std::max(1.0, std::ceil(fraction * static_cast<double>(count_)));
  double seen = 0.0;
  for (int bucket = 0; bucket < kBuckets; ++bucket) {
    seen += buckets_[static_cast<std::size_t>(bucket)];
    if (seen >= wanted) {
      return upperEdge(bucket);
    }
  }
  return maximum();
}

}  // namespace rubber_suspension::node
