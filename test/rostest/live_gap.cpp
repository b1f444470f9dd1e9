// Tests the live gap over topics: thresholds, and forces before, after and in another order than the displacements.
#include <rubber_suspension/Gap.h>
#include <rubber_suspension/MeasuredForce.h>

#include <cmath>

#include "bench.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension {
namespace {

constexpr double kAmplitude = 2e-3;  // [m]
constexpr int kSamples = 4000;       // one window at 1 kHz

class LiveGapTopic : public testing::Test {
 protected:
  void open(const std::string& component) {
    bench_ = std::make_unique<Bench>(component);
    publisher_ = handle_.advertise<MeasuredForce>(component + "/measured_force", 10000);
    subscriber_ = handle_.subscribe<Gap>(component + "/gap", 100, [this](const Gap::ConstPtr& gap) { gap_ = *gap; });
    ASSERT_TRUE(bench_->connect());
    ASSERT_TRUE(spinUntil([&] { return publisher_.getNumSubscribers() > 0; }));
    ASSERT_TRUE(ros_interface::waitForPublishers(subscriber_.getTopic(), kPatience));
  }

  void measure(std::int64_t stamp, double force) {
    MeasuredForce message;
    message.header.stamp = bag::toRosTime(stamp);
    message.force = force;
    publisher_.publish(message);
  }

  // Sends one window of a sine. The measured force is the simulated force times a factor, half a second later.
  void run(int first, double factor) {
    constexpr std::size_t kLate = 500;
    std::vector<Force> answers;
    for (int i = first; i < first + kSamples; ++i) {
      answers.push_back(bench_->ask(kStart + i * kMillisecond, kAmplitude * std::sin(2.0 * element::kPi * 4e-3 * i)));
      if (answers.size() > kLate) {
        answer(answers[answers.size() - kLate - 1], factor);
      }
    }
    for (std::size_t i = answers.size() - kLate; i < answers.size(); ++i) {
      answer(answers[i], factor);
    }
  }

  void answer(const Force& force, double factor) {
    measure(static_cast<std::int64_t>(force.header.stamp.toNSec()), factor * force.force);
  }

  // Waits for the gap of the whole window, because the last messages may be in transit.
  bool waitForWindow(int last) {
    const ros::Time newest = bag::toRosTime(kStart + last * kMillisecond);
    return spinUntil([&] { return gap_.samples >= kSamples && gap_.header.stamp >= newest; });
  }

  std::unique_ptr<Bench> bench_;
  ros::NodeHandle handle_;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
  Gap gap_;
  DiagnosticsWatch diagnostics_;
};

TEST_F(LiveGapTopic, LateForcesAreMatchedAndThresholdsTellTheLevel) {
  open("left_secondary");
  // The node stores samples only after a measured force arrived. Any force counts, even one that is not finite.
  measure(kStart, std::nan(""));
  ASSERT_TRUE(diagnostics_.waitForCount("left_secondary", "measured forces, not finite", 1));
  run(0, 1.0);
  ASSERT_TRUE(waitForWindow(kSamples - 1));
  EXPECT_EQ(gap_.level, Gap::OK);
  EXPECT_EQ(gap_.gap, 0.0);

  // The measured force is 10 % larger than the simulated force, so the gap is 0.1/1.1. Most of it is stiffness.
  run(kSamples, 1.1);
  ASSERT_TRUE(waitForWindow(2 * kSamples - 1));
  EXPECT_NEAR(gap_.gap, 0.1 / 1.1, 0.005);
  EXPECT_EQ(gap_.level, Gap::WARN);
  EXPECT_GT(gap_.share_stiffness, 0.9);
  EXPECT_NEAR(gap_.share_stiffness + gap_.share_loss + gap_.share_harmonics + gap_.share_mean + gap_.share_drift, 1.0,
              1e-9);
  ASSERT_FALSE(gap_.cells.empty());
  EXPECT_EQ(gap_.cells.front().quantity, "stiffness");

  run(2 * kSamples, 1.5);
  ASSERT_TRUE(waitForWindow(3 * kSamples - 1));
  EXPECT_EQ(gap_.level, Gap::ERROR);
  EXPECT_TRUE(spinUntil([&] {
    const auto status = diagnostics_.all().find("left_secondary");
    return status != diagnostics_.all().end() && status->second.level == diagnostic_msgs::DiagnosticStatus::ERROR;
  }));
  EXPECT_TRUE(diagnostics_.waitForCount("left_secondary", "measured forces, matched", 3 * kSamples));
  EXPECT_EQ(diagnostics_.count("left_secondary", "measured forces, without sample"), 0);
}

TEST_F(LiveGapTopic, EarlyForcesAreMatchedAndBadOnesCounted) {
  open("right_secondary");
  for (int i = 0; i < 200; ++i) {
    measure(kStart + i * kMillisecond, 100.0);  // each force arrives before its displacement
  }
  measure(kStart, std::nan(""));
  ASSERT_TRUE(diagnostics_.waitForCount("right_secondary", "measured forces, not finite", 1));
  for (int i = 0; i < 200; ++i) {
    bench_->ask(kStart + i * kMillisecond, 1e-5 * i);
  }
  measure(kStart + 100 * kMillisecond + 1, 100.0);  // no sample has this stamp
  EXPECT_TRUE(diagnostics_.waitForCount("right_secondary", "measured forces, matched", 200));
  EXPECT_TRUE(diagnostics_.waitForCount("right_secondary", "measured forces, without sample", 1));
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "live_gap"); }
