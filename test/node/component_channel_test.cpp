// One component of the node: counts, saving, loading and replacing the model, also from several threads.
#include "node/component_channel.h"

#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr std::int64_t kMillisecond = 1000000;

io::ComponentDescription describe(double stiffness = 3e6) {
  return {"bush",
          {
              {"spring", {{"stiffness", {stiffness}}}},
              {"maxwell", {{"stiffness", {1.2e6}}, {"break_frequency", {2.0}}}},
              {"friction", {{"maximum_force", {6000.0}}, {"displacement", {0.0022}}}},
          }};
}

double wave(int i) { return 2e-3 * std::sin(0.025 * i) + 1e-4 * std::cos(0.3 * i); }

double force(node::ComponentChannel& channel, int i) {
  element::ComponentForce result;
  EXPECT_TRUE(channel.push(i * kMillisecond, wave(i), result));
  return result.total;
}

TEST(ComponentChannel, CountsWhatItDrops) {
  node::ComponentChannel channel(describe(), 0.5);
  force(channel, 2000);
  element::ComponentForce unused;
  EXPECT_FALSE(channel.push(2000 * kMillisecond, 0.0, unused));
  EXPECT_FALSE(channel.push(1999 * kMillisecond, 0.0, unused));
  EXPECT_FALSE(channel.push(2001 * kMillisecond, std::numeric_limits<double>::quiet_NaN(), unused));
  channel.setEnabled(false);
  EXPECT_FALSE(channel.push(2002 * kMillisecond, 0.0, unused));
  channel.setEnabled(true);
  channel.countLost(3);
  const node::ChannelReport report = channel.report();
  EXPECT_EQ(report.accepted, 1U);
  EXPECT_EQ(report.repeated, 1U);
  EXPECT_EQ(report.stepped_back, 1U);
  EXPECT_EQ(report.not_finite, 1U);
  EXPECT_EQ(report.disabled, 1U);
  EXPECT_EQ(report.lost, 3U);
}

TEST(ComponentChannel, ServesAndCountsWhatLiesBeyondItsValidRange) {
  io::ComponentDescription described = describe();
  described.valid_displacement = element::Range::closed(-1e-3, 2e-3);
  node::ComponentChannel channel(described, 0.5);
  node::ComponentChannel everywhere(describe(), 0.5);
  int i = 0;
  for (const double displacement : {0.0, 2e-3, 2.1e-3, -1.1e-3, 1.5}) {
    element::ComponentForce force;
    element::ComponentForce same;
    EXPECT_TRUE(channel.push(++i * kMillisecond, displacement, force));
    EXPECT_TRUE(everywhere.push(i * kMillisecond, displacement, same));
    EXPECT_EQ(force.total, same.total);
  }
  EXPECT_EQ(channel.report().beyond_valid, 3U);
  EXPECT_EQ(everywhere.report().beyond_valid, 0U);
  element::ComponentForce none;
  EXPECT_FALSE(channel.push(++i * kMillisecond, std::numeric_limits<double>::max(), none));
  EXPECT_EQ(channel.report().beyond_valid, 3U) << "no force was served";
  EXPECT_EQ(channel.report().force_not_finite, 1U);
  EXPECT_EQ(channel.report().not_finite, 0U);
}

TEST(ComponentChannel, ReportStartsANewIntervalOfTheLatency) {
  node::ComponentChannel channel(describe(), 0.5);
  channel.countLatency(1000);
  EXPECT_EQ(channel.report().latency.count(), 1U);
  EXPECT_EQ(channel.report().latency.count(), 0U);
}

TEST(ComponentChannel, ASavedStateGoesOnBitByBit) {
  node::ComponentChannel whole(describe(), 0.5);
  node::ComponentChannel before(describe(), 0.5);
  for (int i = 0; i < 700; ++i) {
    EXPECT_EQ(force(whole, i), force(before, i));
  }
  node::ComponentChannel after(describe(), 0.5);
  after.load(before.save());
  for (int i = 700; i < 1400; ++i) {
    EXPECT_EQ(force(whole, i), force(after, i));
  }
}

TEST(ComponentChannel, AStateWithoutSamplesIsANewSpecimen) {
  node::ComponentChannel fresh(describe(), 0.5);
  node::ComponentChannel used(describe(), 0.5);
  force(used, 5000);
  used.load(fresh.save());
  EXPECT_EQ(force(used, 0), force(fresh, 0));
}

TEST(ComponentChannel, RefusesAStateThatIsNotItsOwn) {
  node::ComponentChannel channel(describe(), 0.5);
  force(channel, 0);
  const node::SavedState good = channel.save();
  node::SavedState other_name = good;
  other_name.component = "other";
  node::SavedState other_size = good;
  other_size.memory.push_back(0.0);
  node::SavedState not_finite = good;
  not_finite.memory.front() = std::numeric_limits<double>::infinity();
  node::SavedState other_model = node::ComponentChannel(describe(2.9e6), 0.5).save();
  for (const node::SavedState& bad : {other_name, other_size, not_finite, other_model}) {
    EXPECT_THROW(channel.load(bad), std::invalid_argument);
  }
  node::ComponentChannel untouched(describe(), 0.5);
  force(untouched, 0);
  EXPECT_EQ(force(channel, 1), force(untouched, 1));
}

TEST(ComponentChannel, AnEqualModelTakesTheStateOver) {
  node::ComponentChannel channel(describe(), 0.5);
  node::ComponentChannel untouched(describe(), 0.5);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(force(channel, i), force(untouched, i));
  }
  channel.exchange(node::ComponentChannel::makeModel(describe(), 0.5));
  EXPECT_EQ(force(channel, 100), force(untouched, 100));
  EXPECT_EQ(channel.report().accepted, 101U);
}

TEST(ComponentChannel, AnotherModelStartsAsANewSpecimen) {
  node::ComponentChannel channel(describe(), 0.5);
  for (int i = 0; i < 100; ++i) {
    force(channel, i);
  }
  channel.exchange(node::ComponentChannel::makeModel(describe(2e6), 0.5));
  node::ComponentChannel fresh(describe(2e6), 0.5);
  EXPECT_EQ(force(channel, 100), force(fresh, 100));
}

// One thread serves samples while others call services and read diagnostics. The thread sanitizer would reveal races.
// Without it, the test checks that every accepted sample is counted.
TEST(ComponentChannel, ServesWhileOthersLookAndChange) {
  node::ComponentChannel channel(describe(), 0.5);
  std::atomic<bool> done{false};
  std::thread services([&] {
    while (!done) {
      channel.exchange(node::ComponentChannel::makeModel(describe(), 0.5));
      channel.load(channel.save());
      channel.setEnabled(true);
    }
  });
  std::thread diagnostics([&] {
    while (!done) {
      EXPECT_TRUE(std::isfinite(channel.report().displacement));
    }
  });
  constexpr int kSamples = 20000;
  std::uint64_t accepted = 0;
  for (int i = 0; i < kSamples; ++i) {
    element::ComponentForce result;
    accepted += channel.push(i * kMillisecond, wave(i), result) ? 1 : 0;
    channel.countLatency(1000);
    EXPECT_TRUE(std::isfinite(result.total));
  }
  done = true;
  services.join();
  diagnostics.join();
  const component::StreamCounters counters = channel.report();
  EXPECT_EQ(counters.accepted, accepted);
  EXPECT_EQ(counters.accepted + counters.dropped(), static_cast<std::uint64_t>(kSamples));
}

}  // namespace
}  // namespace rubber_suspension
