// Temperatures with stamps: which temperature applies to a sample, late and early ones, a new replay.
#include "node/temperature_feed.h"

#include "node/component_channel.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

TEST(TemperatureFeed, EachHoldsFromItsStamp) {
  node::TemperatureFeed feed;
  EXPECT_FALSE(feed.take(5));
  feed.add(10, 20.0);
  feed.add(30, 25.0);
  EXPECT_FALSE(feed.take(9));
  EXPECT_FALSE(feed.current());
  EXPECT_EQ(feed.take(10), 20.0);
  EXPECT_FALSE(feed.take(29)) << "the same as before";
  EXPECT_EQ(feed.take(35), 25.0);
  EXPECT_EQ(feed.current(), 25.0);
}

TEST(TemperatureFeed, ALateOneHoldsFromTheNextSampleOn) {
  node::TemperatureFeed feed;
  EXPECT_FALSE(feed.take(100));
  feed.add(50, 22.0);
  EXPECT_EQ(feed.take(101), 22.0);
}

TEST(TemperatureFeed, ANewReplayForgetsWhatWaitsForTheOldOne) {
  node::TemperatureFeed feed;
  feed.add(100, 40.0);
  feed.add(0, 20.0);
  EXPECT_EQ(feed.take(200), 20.0);
}

TEST(TemperatureFeed, LeavesOutTheOldestOfTooMany) {
  node::TemperatureFeed feed;
  const auto most = static_cast<std::int64_t>(node::TemperatureFeed::kMostWaiting);
  for (std::int64_t i = 0; i <= most; ++i) {
    feed.add(i, static_cast<double>(i));
  }
  EXPECT_FALSE(feed.take(0));
  EXPECT_EQ(feed.take(1), 1.0);
  EXPECT_EQ(feed.take(most), static_cast<double>(most));
}

io::ComponentDescription bush(double stiffness = 1.2e6) {
  io::ComponentDescription description("bush", {{"spring", {{"stiffness", {3e6}}}},
                                                {"maxwell", {{"stiffness", {stiffness}}, {"break_frequency", {2.0}}}}});
  description.temperature = {"wlf_shift",
                             {{"c1", {6.13}}, {"c2", {146.8}}, {"reference", {20.0}}, {"vertical", {0.003}}}};
  return description;
}

double push(node::ComponentChannel& channel, std::int64_t stamp, double displacement) {
  element::ComponentForce force;
  EXPECT_TRUE(channel.push(stamp, displacement, force));
  return force.total;
}

// At rest only the spring acts, with 3 kN/mm at 20 degC. At 40 degC the vertical shift multiplies this by 1.06.
TEST(ComponentChannel, FollowsTheTemperature) {
  node::ComponentChannel channel(bush(), 0.5);
  EXPECT_TRUE(channel.setTemperature(1000000, 40.0));
  EXPECT_DOUBLE_EQ(push(channel, 0, 1e-3), 3e3);
  EXPECT_DOUBLE_EQ(push(channel, 1000000, 1e-3), 1.06 * 3e3);
  EXPECT_FALSE(channel.setTemperature(2000000, std::nan("")));
  EXPECT_FALSE(channel.setTemperature(2000000, -200.0));
  const node::ChannelReport report = channel.report();
  EXPECT_TRUE(report.shifts_with_temperature);
  EXPECT_EQ(report.temperature, 40.0);
  EXPECT_EQ(report.refused_temperatures, 2U);
}

TEST(ComponentChannel, TheTemperatureStaysOverResetLoadAndReload) {
  node::ComponentChannel channel(bush(), 0.5);
  push(channel, 0, 1e-3);
  const node::SavedState cold = channel.save();
  channel.setTemperature(1000000, 40.0);
  push(channel, 1000000, 1e-3);
  channel.load(cold);
  EXPECT_DOUBLE_EQ(push(channel, 2000000, 1e-3), 1.06 * 3e3);
  channel.reset();
  EXPECT_DOUBLE_EQ(push(channel, 3000000, 1e-3), 1.06 * 3e3);
  channel.exchange(node::ComponentChannel::makeModel(bush(2e6), 0.5));
  EXPECT_DOUBLE_EQ(push(channel, 4000000, 1e-3), 1.06 * 3e3);
}

TEST(ComponentChannel, ADroppedSampleTakesNoTemperature) {
  node::ComponentChannel channel(bush(), 0.5);
  push(channel, 0, 1e-3);
  channel.setTemperature(5000000, 40.0);
  element::ComponentForce unused;
  EXPECT_FALSE(channel.push(9000000, std::nan(""), unused));
  EXPECT_DOUBLE_EQ(push(channel, 1000000, 1e-3), 3e3);
}

}  // namespace
}  // namespace rubber_suspension
