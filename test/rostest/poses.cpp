// Poses and wrenches: each accepted pose has one wrench, equal to that of an undisturbed stream. Dropped poses are
// counted. Also tests states, bundles and the gap of each direction. Each test has its own component.
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <rubber_suspension/DisplacementArray.h>
#include <rubber_suspension/Gap.h>
#include <rubber_suspension/PoseArray.h>
#include <rubber_suspension/WrenchArray.h>
#include <std_srvs/Trigger.h>

#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include "bench.h"
#include "rubber_suspension/component/pose_stream.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension {
namespace {

using component::Wrench;
using Position = Eigen::Vector3d;
using Rotation = Eigen::Quaterniond;

Rotation turned(double degrees) {
  return Rotation(Eigen::AngleAxisd(degrees * element::kPi / 180.0, Position::UnitX()));
}

Position wayAt(std::int64_t stamp) {
  const double phase = 2.0 * element::kPi * 4.0 * 1e-9 * static_cast<double>(stamp - kStart);
  return 1e-3 * Position(std::sin(phase), 0.5 * std::sin(1.7 * phase), 0.8 * std::sin(0.6 * phase));
}

Rotation turnAt(std::int64_t stamp) {
  return turned(2.0 * std::sin(2.0 * element::kPi * 5e-9 * static_cast<double>(stamp - kStart)));
}

geometry_msgs::Pose messageOf(const Position& position, const Rotation& rotation) {
  geometry_msgs::Pose pose;
  pose.position.x = position.x();
  pose.position.y = position.y();
  pose.position.z = position.z();
  pose.orientation.w = rotation.w();
  pose.orientation.x = rotation.x();
  pose.orientation.y = rotation.y();
  pose.orientation.z = rotation.z();
  return pose;
}

void expectSame(const geometry_msgs::Wrench& message, const Wrench& wrench) {
  EXPECT_EQ(Position(message.force.x, message.force.y, message.force.z), wrench.force);
  EXPECT_EQ(Position(message.torque.x, message.torque.y, message.torque.z), wrench.moment);
}

class Poses : public testing::Test {
 protected:
  void open(const std::string& name) {
    name_ = name;
    static const auto components = io::loadComponentFile(ros::NodeHandle("~").param<std::string>("config_file", ""));
    component_ = std::make_unique<component::SixDirections>(io::selectComponent(components, name).six->makeComponent());
    expected_ = std::make_unique<component::PoseStream>(*component_);
    publisher_ = handle_.advertise<geometry_msgs::PoseStamped>(name + "/pose", 100000);
    measured_ = handle_.advertise<geometry_msgs::WrenchStamped>(name + "/measured_wrench", 100000);
    subscriber_ = handle_.subscribe<geometry_msgs::WrenchStamped>(
        name + "/wrench", 100000,
        [this](const geometry_msgs::WrenchStamped::ConstPtr& wrench) { wrenches_.push_back(*wrench); });
    ASSERT_TRUE(ros_interface::waitForPublishers(subscriber_.getTopic(), kPatience));
    ASSERT_TRUE(spinUntil([this] { return publisher_.getNumSubscribers() > 0 && measured_.getNumSubscribers() > 0; }));
  }

  void send(std::int64_t stamp, const Position& position, const Rotation& rotation) {
    geometry_msgs::PoseStamped message;
    message.header.stamp = bag::toRosTime(stamp);
    message.header.frame_id = "body_a";
    message.pose = messageOf(position, rotation);
    publisher_.publish(message);
  }

  // Sends a pose that must be answered, and checks its wrench.
  void expectAnswer(std::int64_t stamp, const Position& position, const Rotation& rotation) {
    const std::size_t before = wrenches_.size();
    send(stamp, position, rotation);
    ASSERT_TRUE(spinUntil([&] { return wrenches_.size() > before; })) << stamp;
    EXPECT_EQ(wrenches_.size(), before + 1);
    EXPECT_EQ(wrenches_.back().header.stamp, bag::toRosTime(stamp));
    EXPECT_EQ(wrenches_.back().header.frame_id, "body_a");
    expectSame(wrenches_.back().wrench, expected_->push(stamp, position, rotation).force.wrench);
  }

  void run(std::int64_t first, int count) {
    for (int i = 0; i < count; ++i) {
      const std::int64_t stamp = first + i * kMillisecond;
      expectAnswer(stamp, wayAt(stamp), turnAt(stamp));
    }
  }

  // Checks the counters. Counters that `expected` does not list must be zero.
  void expectCounts(std::map<std::string, long> expected) {
    for (const char* key :
         {"dropped", "dropped, not finite", "dropped, repeated stamp", "dropped, stepped back", "dropped, no rotation",
          "dropped, beyond measure", "beyond valid rotation", "restarts", "time gaps bridged"}) {
      expected.emplace(key, 0);
    }
    const long accepted = expected.at("accepted");
    ASSERT_TRUE(diagnostics_.waitForCount(name_, "accepted", accepted));
    for (const auto& [key, value] : expected) {
      EXPECT_TRUE(diagnostics_.waitForCount(name_, key, value));
    }
    EXPECT_EQ(wrenches_.size(), static_cast<std::size_t>(accepted));
  }

  static void call(const std::string& service) {
    std_srvs::Trigger trigger;
    ASSERT_TRUE(ros_interface::callService(service, trigger));
    EXPECT_TRUE(trigger.response.success) << trigger.response.message;
  }

  std::string name_;
  std::unique_ptr<component::SixDirections> component_;
  std::unique_ptr<component::PoseStream> expected_;
  ros::NodeHandle handle_;
  ros::Publisher publisher_;
  ros::Publisher measured_;
  ros::Subscriber subscriber_;
  std::vector<geometry_msgs::WrenchStamped> wrenches_;
  DiagnosticsWatch diagnostics_;
};

TEST_F(Poses, EveryPoseHasOneWrenchWithItsHeader) {
  open("bush");
  constexpr std::size_t kSamples = 3000;
  const auto stamp = [](std::size_t i) { return kStart + static_cast<std::int64_t>(i) * kMillisecond; };
  for (std::size_t i = 0; i < kSamples; ++i) {
    send(stamp(i), wayAt(stamp(i)), turnAt(stamp(i)));
  }
  ASSERT_TRUE(spinUntil([&] { return wrenches_.size() >= kSamples; }));
  for (std::size_t i = 0; i < kSamples; ++i) {
    EXPECT_EQ(wrenches_[i].header.stamp, bag::toRosTime(stamp(i)));
    EXPECT_EQ(wrenches_[i].header.frame_id, "body_a");
    expectSame(wrenches_[i].wrench, expected_->push(stamp(i), wayAt(stamp(i)), turnAt(stamp(i))).force.wrench);
  }
  expectCounts({{"accepted", 3000}});
}

TEST_F(Poses, AQuaternionWhoseLengthIsNotOneIsDropped) {
  open("bad_quaternion");
  run(kStart, 20);
  for (const double length : {1.002, 0.998, 0.0}) {
    Rotation rotation = turned(1.0);
    rotation.coeffs() *= length;
    send(kStart + 20 * kMillisecond, wayAt(kStart), rotation);
  }
  Rotation rounded = turned(1.0);
  rounded.coeffs() *= 1.0005;
  expectAnswer(kStart + 20 * kMillisecond, wayAt(kStart), rounded);
  run(kStart + 21 * kMillisecond, 20);
  expectCounts({{"accepted", 41}, {"dropped", 3}, {"dropped, no rotation", 3}});
}

TEST_F(Poses, ARotationBeyondTheMeasureIsDropped) {
  open("beyond_measure");
  run(kStart, 20);
  send(kStart + 20 * kMillisecond, Position::Zero(), turned(179.9));
  run(kStart + 21 * kMillisecond, 20);
  expectCounts({{"accepted", 40}, {"dropped", 1}, {"dropped, beyond measure", 1}});
}

TEST_F(Poses, ARotationBeyondTheStatedValidityIsAnsweredWithAWarning) {
  open("beyond_valid");
  run(kStart, 20);
  expectAnswer(kStart + 20 * kMillisecond, Position::Zero(), turned(40.0));
  expectCounts({{"accepted", 21}, {"beyond valid rotation", 1}});
}

TEST_F(Poses, ATimeGapIsBridged) {
  open("time_gap");
  run(kStart, 20);
  run(kStart + 900 * kMillisecond, 20);
  expectCounts({{"accepted", 40}, {"time gaps bridged", 1}});
}

TEST_F(Poses, AJumpBackResets) {
  open("restart");
  run(kStart + 5000 * kMillisecond, 20);
  run(kStart, 20);
  component::PoseStream fresh(*component_);
  const std::int64_t last = kStart + 19 * kMillisecond;
  Wrench wrench;
  for (std::int64_t stamp = kStart; stamp <= last; stamp += kMillisecond) {
    wrench = fresh.push(stamp, wayAt(stamp), turnAt(stamp)).force.wrench;
  }
  expectSame(wrenches_.back().wrench, wrench);
  expectCounts({{"accepted", 40}, {"restarts", 1}});
}

TEST_F(Poses, AStampThatRepeatsOrStepsBackIsDropped) {
  open("repeated");
  run(kStart, 20);
  send(kStart + 19 * kMillisecond, Position::Zero(), turned(0.0));
  send(kStart + 5 * kMillisecond, Position::Zero(), turned(0.0));
  run(kStart + 20 * kMillisecond, 20);
  expectCounts({{"accepted", 40}, {"dropped", 2}, {"dropped, repeated stamp", 1}, {"dropped, stepped back", 1}});
}

TEST_F(Poses, WhatIsNotFiniteIsDropped) {
  open("not_finite");
  run(kStart, 20);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  send(kStart + 20 * kMillisecond, Position(0.0, nan, 0.0), turned(0.0));
  send(kStart + 20 * kMillisecond, Position::Zero(), Rotation(nan, 0.0, 0.0, 0.0));
  run(kStart + 20 * kMillisecond, 20);
  expectCounts({{"accepted", 40}, {"dropped", 2}, {"dropped, not finite", 2}});
}

TEST_F(Poses, ALoadedStateGoesOnWithTheSameBits) {
  open("saved");
  run(kStart, 50);
  call("/simulate/save_state");
  run(kStart + 50 * kMillisecond, 30);
  call("/simulate/load_state");
  for (int i = 0; i < 30; ++i) {
    const std::int64_t stamp = kStart + (50 + i) * kMillisecond;
    const std::size_t before = wrenches_.size();
    send(stamp, wayAt(stamp), turnAt(stamp));
    ASSERT_TRUE(spinUntil([&] { return wrenches_.size() > before; }));
    const geometry_msgs::WrenchStamped& first = wrenches_[50 + static_cast<std::size_t>(i)];
    EXPECT_EQ(wrenches_.back().header.stamp, first.header.stamp);
    EXPECT_EQ(wrenches_.back().wrench, first.wrench);
  }
  call("/simulate/reset");
  expected_ = std::make_unique<component::PoseStream>(*component_);
  run(kStart, 10);
}

// The measured force along x is a fifth larger than the simulated force. All other directions agree.
TEST_F(Poses, TheGapIsThatOfEachDirection) {
  open("measured");
  std::map<std::string, Gap> gaps;
  std::vector<ros::Subscriber> subscribers;
  for (const std::string direction : {"x", "y", "z", "rx"}) {
    subscribers.push_back(
        handle_.subscribe<Gap>("measured/" + direction + "/gap", 10,
                               [&gaps, direction](const Gap::ConstPtr& gap) { gaps[direction] = *gap; }));
  }
  const auto known = [&](const char* direction) { return gaps.count(direction) > 0 && gaps[direction].samples > 2000; };
  for (int i = 0; i < 3000; ++i) {
    const std::int64_t stamp = kStart + i * kMillisecond;
    Wrench wrench = expected_->push(stamp, wayAt(stamp), turnAt(stamp)).force.wrench;
    wrench.force.x() *= 1.2;
    geometry_msgs::WrenchStamped message;
    message.header.stamp = bag::toRosTime(stamp);
    message.wrench.force.x = wrench.force.x();
    message.wrench.force.y = wrench.force.y();
    message.wrench.force.z = wrench.force.z();
    message.wrench.torque.x = wrench.moment.x();
    message.wrench.torque.y = wrench.moment.y();
    message.wrench.torque.z = wrench.moment.z();
    if (i % 2 == 0) {  // half of the forces arrive before their pose, the others after it
      measured_.publish(message);
    }
    send(stamp, wayAt(stamp), turnAt(stamp));
    if (i % 2 != 0) {
      measured_.publish(message);
    }
  }
  ASSERT_TRUE(spinUntil([&] { return known("x") && known("y") && known("z") && known("rx"); }));
  EXPECT_NEAR(gaps["x"].gap_as_recorded, 0.2 / 1.2, 0.02);
  EXPECT_EQ(gaps["x"].level, Gap::WARN);
  for (const char* direction : {"y", "z", "rx"}) {
    EXPECT_LT(gaps[direction].gap_as_recorded, 1e-6) << direction;
    EXPECT_EQ(gaps[direction].level, Gap::OK) << direction;
  }
}

TEST_F(Poses, ABundleIsAnsweredByTheSameComponents) {
  open("bush");
  std::vector<WrenchArray> answers;
  const ros::Subscriber subscriber = handle_.subscribe<WrenchArray>(
      "wrenches", 100, [&](const WrenchArray::ConstPtr& answer) { answers.push_back(*answer); });
  const ros::Publisher publisher = handle_.advertise<PoseArray>("poses", 100);
  const ros::Publisher displacements = handle_.advertise<DisplacementArray>("displacements", 100);
  ASSERT_TRUE(ros_interface::waitForPublishers(subscriber.getTopic(), kPatience));
  ASSERT_TRUE(spinUntil([&] { return publisher.getNumSubscribers() > 0 && displacements.getNumSubscribers() > 0; }));
  call("/simulate/reset");
  PoseArray bundle;
  bundle.header.stamp = bag::toRosTime(kStart);
  bundle.header.frame_id = "body_a";
  bundle.components = {"bush", "measured"};
  bundle.poses = {messageOf(wayAt(kStart + kMillisecond), turned(1.0)), messageOf(wayAt(kStart), turned(179.9))};
  publisher.publish(bundle);
  ASSERT_TRUE(spinUntil([&] { return !answers.empty(); }));
  EXPECT_EQ(answers[0].header.stamp, bundle.header.stamp);
  EXPECT_EQ(answers[0].header.frame_id, "body_a");
  ASSERT_EQ(answers[0].components, std::vector<std::string>{"bush"});  // the rotation of the other bush is out of range
  expectSame(answers[0].wrenches.at(0),
             expected_->push(kStart, wayAt(kStart + kMillisecond), turned(1.0)).force.wrench);
  // A sample on the single topic continues from the state after the bundle.
  run(kStart + kMillisecond, 5);
  // A component of six directions does not accept a displacement.
  DisplacementArray wrong;
  wrong.header.stamp = bag::toRosTime(kStart);
  wrong.components = {"bush"};
  wrong.displacement = {1e-3};
  displacements.publish(wrong);
  EXPECT_TRUE(diagnostics_.waitForCount("bundled topics", "dropped, malformed", 1));
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "poses"); }
