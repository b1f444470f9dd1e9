// Checks a bench over its topics: a displacement gives one force, whose value follows from the component file.
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rubber_suspension/Displacement.h>
#include <rubber_suspension/Force.h>

#include <optional>

namespace {

class Bench {
 public:
  Bench()
      : publisher_(handle_.advertise<rubber_suspension::Displacement>("mount/displacement", 10)),
        subscriber_(handle_.subscribe("mount/force", 10, &Bench::take, this)) {}

  bool waitForNode() {
    return waitFor([this] { return publisher_.getNumSubscribers() > 0 && subscriber_.getNumPublishers() > 0; });
  }

  /// Returns the force that answers a displacement, or nothing if no force arrives.
  std::optional<rubber_suspension::Force> ask(double displacement) {
    rubber_suspension::Displacement question;
    question.header.stamp = ros::Time(100, 5);
    question.displacement = displacement;
    publisher_.publish(question);
    waitFor([this] { return answer_.has_value(); });
    return answer_;
  }

 private:
  void take(const rubber_suspension::Force& force) { answer_ = force; }

  template <class Condition>
  bool waitFor(const Condition& condition) {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(30.0);
    while (!condition() && ros::WallTime::now() < end) {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
    }
    return condition();
  }

  ros::NodeHandle handle_;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
  std::optional<rubber_suspension::Force> answer_;
};

TEST(Bench, answersWithTheForceOfTheSpring) {
  Bench bench;
  ASSERT_TRUE(bench.waitForNode());
  const auto force = bench.ask(1.5e-3);
  ASSERT_TRUE(force.has_value());
  EXPECT_DOUBLE_EQ(force->force, 2e6 * 1.5e-3);
  EXPECT_EQ(force->header.stamp, ros::Time(100, 5));
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "bench_test");
  return RUN_ALL_TESTS();
}
