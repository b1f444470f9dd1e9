// Percentiles of the latency histogram agree with those of sorted samples.
#include "node/latency_histogram.h"

#include "support/test.h"

namespace rubber_suspension {
namespace {

TEST(LatencyHistogram, IsZeroWithoutSamples) {
  const node::LatencyHistogram histogram;
  EXPECT_EQ(histogram.percentile(0.5), 0.0);
  EXPECT_EQ(histogram.maximum(), 0.0);
}

TEST(LatencyHistogram, PercentilesAreExactToAnEighthOfAnOctave) {
  std::mt19937 random(7);
  std::lognormal_distribution<double> latency(std::log(1e5), 2.0);  // around 100 us, over some decades
  node::LatencyCounter counter;
  std::vector<double> samples;
  for (int i = 0; i < 100000; ++i) {
    const auto nanoseconds = static_cast<std::int64_t>(latency(random));
    counter.add(nanoseconds);
    samples.push_back(1e-9 * static_cast<double>(nanoseconds));
  }
  std::sort(samples.begin(), samples.end());
  const node::LatencyHistogram histogram = counter.take();
  for (const double fraction : {0.01, 0.1, 0.5, 0.9, 0.99, 0.999}) {
    const double exact = samples[static_cast<std::size_t>(fraction * 1e5) - 1];
    // The percentile is the upper edge of a bucket with a width of an eighth of an octave, so it is never too low.
    EXPECT_GE(histogram.percentile(fraction), exact);
    EXPECT_LE(histogram.percentile(fraction), exact * std::exp2(0.125) * (1.0 + 1e-12));
  }
  EXPECT_EQ(histogram.maximum(), samples.back());
  EXPECT_EQ(histogram.count(), samples.size());
}

TEST(LatencyHistogram, TakesAnyNumber) {
  node::LatencyCounter counter;
  for (const std::int64_t nanoseconds : {std::int64_t{-5}, std::int64_t{0}, std::int64_t{7}, std::int64_t{8},
                                         std::numeric_limits<std::int64_t>::max() / 4}) {
    counter.add(nanoseconds);
  }
  EXPECT_EQ(counter.take().count(), 5U);
}

TEST(LatencyHistogram, CountsEachSampleOnceWhileItIsTaken) {
  constexpr std::uint64_t kSamples = 100000;
  node::LatencyCounter counter;
  std::thread adding([&] {
    for (std::uint64_t i = 0; i < kSamples; ++i) {
      counter.add(1000);
    }
  });
  std::uint64_t taken = 0;
  for (int i = 0; i < 100; ++i) {
    taken += counter.take().count();
  }
  adding.join();
  EXPECT_EQ(taken + counter.take().count(), kSamples);
}

}  // namespace
}  // namespace rubber_suspension
