// Serving samples without a master: filling messages and answering bundles, without allocations or growing memory.
#include "ros_interface/bundle_server.h"
#include "ros_interface/message_pool.h"
#include "ros_interface/sample_server.h"
#include "support/allocation_counter.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr std::int64_t kMillisecond = 1000000;

io::ComponentDescription describe(const std::string& name) {
  return {name,
          {
              {"spring", {{"stiffness", {3e6}}}},
              {"maxwell", {{"stiffness", {1.2e6}}, {"break_frequency", {2.0}}}},
              {"friction", {{"maximum_force", {6000.0}}, {"displacement", {0.0022}}}},
          }};
}

class NodeCore : public testing::Test {
 protected:
  NodeCore() {
    for (const char* name : {"front_left_axle_box_bush", "front_right_axle_box_bush", "rear"}) {
      owned_.push_back(std::make_unique<node::ComponentChannel>(describe(name), 0.5));
      channels_.push_back(owned_.back().get());
    }
    group_ = std::make_unique<node::ChannelGroup>(channels_);
  }

  DisplacementArray bundle(int i) const {
    DisplacementArray message;
    message.header.stamp.fromNSec(static_cast<std::uint64_t>(i) * kMillisecond + 1);
    message.displacement = {1e-3 * std::sin(0.02 * i), 2e-3 * std::sin(0.03 * i), 1e-3};
    return message;
  }

  std::vector<std::unique_ptr<node::ComponentChannel>> owned_;
  std::vector<node::ComponentChannel*> channels_;
  std::unique_ptr<node::ChannelGroup> group_;
};

TEST_F(NodeCore, ABundleGivesTheForcesOfTheSingleTopics) {
  std::vector<std::unique_ptr<node::ComponentChannel>> alone;
  for (const node::ComponentChannel* channel : channels_) {
    alone.push_back(std::make_unique<node::ComponentChannel>(describe(channel->name()), 0.5));
  }
  ForceArray answer;
  for (int i = 0; i < 1000; ++i) {
    const DisplacementArray message = bundle(i);
    ASSERT_TRUE(ros_interface::answerBundle(message, *group_, answer));
    ASSERT_EQ(answer.components.size(), 3U);
    for (std::size_t c = 0; c < 3; ++c) {
      element::ComponentForce force;
      ASSERT_TRUE(
          alone[c]->push(static_cast<std::int64_t>(message.header.stamp.toNSec()), message.displacement[c], force));
      ASSERT_EQ(answer.components[c], channels_[c]->name());
      ASSERT_EQ(answer.displacement[c], message.displacement[c]);
      ASSERT_EQ(answer.force[c], force.total);
      ASSERT_EQ(answer.elastic[c], force.elastic);
      ASSERT_EQ(answer.viscous[c], force.viscous);
      ASSERT_EQ(answer.friction[c], force.friction);
    }
  }
}

TEST_F(NodeCore, ABundleMayNameSomeComponentsInAnyOrder) {
  DisplacementArray message = bundle(1);
  message.components = {"rear", "front_left_axle_box_bush"};
  message.displacement = {1e-3, 2e-3};
  ForceArray answer;
  ASSERT_TRUE(ros_interface::answerBundle(message, *group_, answer));
  EXPECT_EQ(answer.components, message.components);
  EXPECT_NEAR(answer.force[0], 3000.0, 1e-9);
  EXPECT_NEAR(answer.force[1], 6000.0, 1e-9);
  EXPECT_FALSE(channels_[1]->report().started);
}

TEST_F(NodeCore, ABundleAnswersOnlyWhatWasAccepted) {
  DisplacementArray message = bundle(1);
  message.displacement[1] = std::numeric_limits<double>::quiet_NaN();
  ForceArray answer;
  ASSERT_TRUE(ros_interface::answerBundle(message, *group_, answer));
  EXPECT_EQ(answer.components, (std::vector<std::string>{"front_left_axle_box_bush", "rear"}));
  EXPECT_EQ(channels_[1]->report().not_finite, 1U);
}

TEST_F(NodeCore, AMalformedBundleTouchesNothing) {
  DisplacementArray unknown = bundle(1);
  unknown.components = {"rear", "front", "front_left_axle_box_bush"};
  DisplacementArray too_short = bundle(1);
  too_short.displacement.pop_back();
  DisplacementArray too_long = bundle(1);
  too_long.components.assign(4, "rear");
  too_long.displacement.assign(4, 0.0);
  ForceArray answer;
  for (const DisplacementArray& message : {unknown, too_short, too_long}) {
    EXPECT_FALSE(ros_interface::answerBundle(message, *group_, answer));
  }
  for (node::ComponentChannel* channel : channels_) {
    EXPECT_FALSE(channel->report().started);
  }
}

using Watch = node::SequenceWatch<std::shared_ptr<int>>;

// Serves a sample as the node does: counts lost samples, steps, and fills a message of the pool.
void serve(node::ComponentChannel& channel, Watch& watch, ros_interface::MessagePool<Force>& pool,
           const Displacement& sample) {
  static const auto sender = std::make_shared<int>();
  channel.countLost(watch.take(sender, sample.header.seq));
  element::ComponentForce force;
  if (channel.push(static_cast<std::int64_t>(sample.header.stamp.toNSec()), sample.displacement, force)) {
    const auto message = pool.take();
    ros_interface::fillForce(sample, force, *message);
    EXPECT_TRUE(std::isfinite(message->force));
  }
  channel.countLatency(1000);
}

TEST_F(NodeCore, ServesMillionsOfSamplesWithoutAllocation) {
  ros_interface::MessagePool<Force> pool;
  Watch watch;
  std::mt19937 random(3);
  std::uniform_int_distribution<int> kind(0, 999);
  Displacement sample;
  sample.header.frame_id = "a frame with a name that is longer than short strings are";
  for (int i = 0; i < 64; ++i) {  // the strings of the pool reach their final length
    sample.header.stamp.fromNSec(static_cast<std::uint64_t>(i + 1) * kMillisecond);
    serve(*channels_[0], watch, pool, sample);
  }
  channels_[0]->gap().addMeasured(1, 0.0);
  const test::AllocationCounter allocations;
  constexpr int kSamples = 3000000;
  std::uint64_t stamp = 100 * kMillisecond;
  for (int i = 0; i < kSamples; ++i) {
    const int which = kind(random);
    stamp += which == 0 ? 0 : kMillisecond;        // repeated stamp
    stamp -= which == 1 ? 2 * kMillisecond : 0;    // step back
    stamp += which == 2 ? 700 * kMillisecond : 0;  // time gap
    sample.header.stamp.fromNSec(stamp);
    sample.header.seq += which == 5 ? 2 : 1;  // one message was lost
    sample.displacement = which == 3   ? std::numeric_limits<double>::quiet_NaN()
                          : which == 4 ? std::numeric_limits<double>::max()
                                       : 2e-3 * std::sin(0.01 * i);
    serve(*channels_[0], watch, pool, sample);
    channels_[0]->gap().addMeasured(static_cast<std::int64_t>(stamp), 0.0);
  }
  EXPECT_EQ(allocations.count(), 0U);
  const node::ChannelReport report = channels_[0]->report();
  EXPECT_EQ(report.accepted + report.dropped(), static_cast<std::uint64_t>(kSamples) + 64U);
  EXPECT_GT(report.lost, 0U);
  EXPECT_GT(report.not_finite, 0U);
  EXPECT_GT(report.force_not_finite, 0U);
  EXPECT_GT(report.repeated, 0U);
  EXPECT_GT(report.stepped_back, 0U);
  for (const double value : channels_[0]->save().memory) {
    EXPECT_TRUE(std::isfinite(value));
  }
}

TEST_F(NodeCore, AnswersBundlesWithoutAllocation) {
  ForceArray answer;
  DisplacementArray message = bundle(0);
  ASSERT_TRUE(ros_interface::answerBundle(message, *group_, answer));
  const test::AllocationCounter allocations;
  for (int i = 1; i < 10000; ++i) {
    message.header.stamp.fromNSec(static_cast<std::uint64_t>(i) * kMillisecond + 1);
    message.displacement[0] = 1e-3 * std::sin(0.02 * i);
    ros_interface::answerBundle(message, *group_, answer);
  }
  EXPECT_EQ(allocations.count(), 0U);
  EXPECT_EQ(channels_[0]->report().accepted, 10000U);
}

}  // namespace
}  // namespace rubber_suspension
