// Matching of measured and simulated forces that are late, early, repeated or missing, over restarts, from two threads.
#include "node/gap_monitor.h"

#include "support/allocation_counter.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr std::int64_t kMillisecond = 1000000;
constexpr double kLong = 1e6;  // [s], longer than any test

// Makes the monitor store samples, which it begins only when a force was measured.
void wake(node::GapMonitor& monitor) { monitor.addMeasured(-1, std::numeric_limits<double>::quiet_NaN()); }

TEST(GapMonitor, KeepsNothingUntilForcesAreMeasured) {
  node::GapMonitor monitor;
  monitor.addSimulated(1, 0.0, 1.0);
  EXPECT_TRUE(monitor.window(kLong).empty());
  EXPECT_EQ(monitor.counters().matched, 0U);
}

TEST(GapMonitor, MatchesLateAndEarlyForces) {
  node::GapMonitor monitor;
  wake(monitor);
  monitor.addMeasured(3 * kMillisecond, 30.0);  // before its sample
  for (int i = 1; i <= 4; ++i) {
    monitor.addSimulated(i * kMillisecond, i, 10.0 * i + 1.0);
  }
  monitor.addMeasured(1 * kMillisecond, 10.0);  // after later samples
  const auto samples = monitor.window(kLong);
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[0].stamp, 1 * kMillisecond);
  EXPECT_EQ(samples[0].measured, 10.0);
  EXPECT_EQ(samples[0].simulated, 11.0);
  EXPECT_EQ(samples[1].stamp, 3 * kMillisecond);
  EXPECT_EQ(samples[1].measured, 30.0);
  EXPECT_EQ(samples[1].displacement, 3.0);
}

TEST(GapMonitor, CountsWhatFindsNoSample) {
  node::GapMonitor monitor;
  wake(monitor);
  EXPECT_EQ(monitor.counters().not_finite, 1U);
  monitor.addSimulated(2 * kMillisecond, 0.0, 0.0);
  monitor.addSimulated(4 * kMillisecond, 0.0, 0.0);
  monitor.addMeasured(3 * kMillisecond, 1.0);  // between two samples
  monitor.addMeasured(1 * kMillisecond, 1.0);  // before the first sample
  monitor.addMeasured(2 * kMillisecond, 1.0);
  monitor.addMeasured(2 * kMillisecond, 2.0);  // repeated
  monitor.addMeasured(5 * kMillisecond, 1.0);  // waits for a sample that does not come
  monitor.addSimulated(6 * kMillisecond, 0.0, 0.0);
  EXPECT_EQ(monitor.counters().matched, 1U);
  EXPECT_EQ(monitor.counters().unmatched, 4U);
  EXPECT_EQ(monitor.window(kLong).at(0).measured, 1.0);
}

TEST(GapMonitor, WindowEndsAtTheNewestSample) {
  node::GapMonitor monitor;
  wake(monitor);
  for (int i = 0; i < 1000; ++i) {
    monitor.addSimulated(i * kMillisecond, 0.0, 0.0);
    monitor.addMeasured(i * kMillisecond, 1.0);
  }
  const auto samples = monitor.window(0.1);
  ASSERT_EQ(samples.size(), 101U);
  EXPECT_EQ(samples.front().stamp, 899 * kMillisecond);
  EXPECT_EQ(samples.back().stamp, 999 * kMillisecond);
}

TEST(GapMonitor, AStepBackIsANewReplay) {
  node::GapMonitor monitor;
  wake(monitor);
  monitor.addSimulated(5000 * kMillisecond, 0.0, 0.0);
  monitor.addMeasured(5000 * kMillisecond, 1.0);
  monitor.addSimulated(0, 0.0, 0.0);
  EXPECT_TRUE(monitor.window(kLong).empty());
  monitor.addMeasured(0, 2.0);
  ASSERT_EQ(monitor.window(kLong).size(), 1U);
  monitor.clear();
  EXPECT_TRUE(monitor.window(kLong).empty());
}

TEST(GapMonitor, ForgetsTheOldestAndAllocatesNothing) {
  node::GapMonitor monitor;
  wake(monitor);
  const test::AllocationCounter allocations;
  constexpr int kSamples = 3 * static_cast<int>(node::GapMonitor::kCapacity);
  for (int i = 0; i < kSamples; ++i) {
    monitor.addMeasured(i * kMillisecond, i);
    monitor.addSimulated(i * kMillisecond, 0.0, 0.0);
  }
  EXPECT_EQ(allocations.count(), 0U);
  const auto samples = monitor.window(kLong);
  ASSERT_EQ(samples.size(), node::GapMonitor::kCapacity);
  EXPECT_EQ(samples.back().measured, kSamples - 1);
  EXPECT_EQ(samples.front().measured, kSamples - static_cast<int>(node::GapMonitor::kCapacity));
}

TEST(GapMonitor, TakesMemoryAsSamplesCome) {
  constexpr std::size_t kLarge = 10 * node::GapMonitor::kCapacity + 1;
  const test::AllocationCounter before;
  node::GapMonitor monitor(kLarge);
  EXPECT_EQ(before.count(), 0U);
  wake(monitor);
  const test::AllocationCounter allocations;
  std::int64_t next = 0;
  const auto add = [&](std::size_t samples) {
    for (std::size_t i = 0; i < samples; ++i, ++next) {
      monitor.addMeasured(next * kMillisecond, static_cast<double>(next));
      monitor.addSimulated(next * kMillisecond, 0.0, 0.0);
    }
  };
  add(node::GapMonitor::kCapacity);
  EXPECT_EQ(allocations.count(), 0U);
  add(2 * kLarge);
  EXPECT_LE(allocations.count(), kLarge / 4096 + 1);
  const auto samples = monitor.window(kLong);
  ASSERT_EQ(samples.size(), kLarge);
  for (std::size_t i = 0; i < kLarge; ++i) {
    ASSERT_EQ(samples[i].measured, static_cast<double>(next) - static_cast<double>(kLarge - i));
  }
}

// Such numbers exceed what a component accepts, and their squares might overflow.
TEST(GapMonitor, NumbersBeyondAnyComponentAreNoForces) {
  node::GapMonitor monitor;
  wake(monitor);
  for (const double force : {1e31, -1e308}) {
    EXPECT_FALSE(monitor.addMeasured(0, force));
  }
  EXPECT_EQ(monitor.counters().not_finite, 3U);
  monitor.addSimulated(kMillisecond, 1e300, 3e306);
  EXPECT_TRUE(monitor.addMeasured(kMillisecond, 1.0));
  EXPECT_TRUE(monitor.window(kLong).empty());
}

TEST(GapMonitor, ForcesThatRunFarAheadAreBounded) {
  node::GapMonitor monitor;
  for (int i = 0; i < 10000; ++i) {
    monitor.addMeasured((1000 + i) * kMillisecond, 1.0);
  }
  EXPECT_EQ(monitor.counters().unmatched, 10000U - node::GapMonitor::kWaiting);
}

TEST(GapMonitor, TakesSamplesForcesAndLooksFromThreeThreads) {
  node::GapMonitor monitor;
  wake(monitor);
  constexpr int kSamples = 20000;
  std::thread simulated([&] {
    for (int i = 0; i < kSamples; ++i) {
      monitor.addSimulated(i * kMillisecond, i, i);
    }
  });
  std::thread measured([&] {
    for (int i = 0; i < kSamples; ++i) {
      monitor.addMeasured(i * kMillisecond, i);
    }
  });
  for (int i = 0; i < 20; ++i) {
    for (const node::MatchedSample& sample : monitor.window(1.0)) {
      ASSERT_EQ(sample.simulated, sample.measured);
    }
  }
  simulated.join();
  measured.join();
  // A force is unmatched if too many others waited or its sample was discarded. Some may still wait.
  const node::MatchCounters counters = monitor.counters();
  EXPECT_LE(counters.matched + counters.unmatched, static_cast<std::uint64_t>(kSamples));
  EXPECT_GT(counters.matched, 0U);
}

}  // namespace
}  // namespace rubber_suspension
