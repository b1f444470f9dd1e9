// Tests the node in normal operation: one force per displacement, headers, parts of the force, diagnostics, reset.
#include <rubber_suspension/DisplacementArray.h>
#include <rubber_suspension/ForceArray.h>
#include <std_srvs/Trigger.h>

#include <cmath>

#include "bench.h"

namespace rubber_suspension {
namespace {

TEST(Nominal, EverySampleHasOneForceWithItsHeader) {
  Bench bench("left_secondary");
  ASSERT_TRUE(bench.connect());
  constexpr std::size_t kSamples = 5000;
  for (std::size_t i = 0; i < kSamples; ++i) {
    bench.send(kStart + static_cast<std::int64_t>(i) * kMillisecond, 1e-3 * std::sin(0.025 * static_cast<double>(i)));
  }
  ASSERT_TRUE(bench.waitForForces(kSamples));
  for (std::size_t i = 0; i < kSamples; ++i) {
    const Force& force = bench.forces[i];
    EXPECT_EQ(force.header.stamp, bag::toRosTime(kStart + static_cast<std::int64_t>(i) * kMillisecond));
    EXPECT_EQ(force.header.frame_id, "bench");
    EXPECT_EQ(force.displacement, 1e-3 * std::sin(0.025 * static_cast<double>(i)));
    // The parts are summed in another order than the total, so both agree only up to rounding.
    EXPECT_NEAR(force.force, force.elastic + force.viscous + force.friction, 1e-12 * (1.0 + std::abs(force.force)));
  }
}

TEST(Nominal, RestAtADisplacementIsTheStaticForce) {
  Bench bench("left_secondary");
  ASSERT_TRUE(bench.connect());
  std_srvs::Trigger reset;
  ASSERT_TRUE(ros_interface::callService("/simulate/reset", reset));
  EXPECT_TRUE(reset.response.success) << reset.response.message;
  // A component at rest is relaxed, so 2 mm give the force of the static stiffness of 3 kN/mm.
  EXPECT_NEAR(bench.ask(kStart, 0.002).force, 6000.0, 1e-6);
}

TEST(Nominal, ABundleIsAnsweredByTheSameComponents) {
  ros::NodeHandle handle;
  std::vector<ForceArray> answers;
  const ros::Subscriber subscriber = handle.subscribe<ForceArray>(
      "forces", 100, [&](const ForceArray::ConstPtr& answer) { answers.push_back(*answer); });
  const ros::Publisher publisher = handle.advertise<DisplacementArray>("displacements", 100);
  ASSERT_TRUE(ros_interface::waitForPublishers(subscriber.getTopic(), kPatience));
  ASSERT_TRUE(spinUntil([&] { return publisher.getNumSubscribers() > 0; }));
  std_srvs::Trigger reset;
  ASSERT_TRUE(ros_interface::callService("/simulate/reset", reset));
  DisplacementArray bundle;
  bundle.header.stamp = bag::toRosTime(kStart);
  bundle.displacement = {0.002, 0.001};
  publisher.publish(bundle);
  ASSERT_TRUE(spinUntil([&] { return !answers.empty(); }));
  EXPECT_EQ(answers[0].header.stamp, bundle.header.stamp);
  EXPECT_EQ(answers[0].components, (std::vector<std::string>{"left_secondary", "right_secondary"}));
  EXPECT_NEAR(answers[0].force[0], 6000.0, 1e-6);
  EXPECT_NEAR(answers[0].force[1], 3000.0, 1e-6);
  // A sample on the single topic continues from the state after the bundle.
  Bench bench("left_secondary");
  ASSERT_TRUE(bench.connect());
  EXPECT_GT(bench.ask(kStart + kMillisecond, 0.003).viscous, 0.0);
  ASSERT_TRUE(ros_interface::callService("/simulate/reset", reset));
}

TEST(Nominal, DiagnosticsTellRateAndCounts) {
  DiagnosticsWatch diagnostics;
  Bench bench("right_secondary");
  ASSERT_TRUE(bench.connect());
  for (int i = 0; i < 100; ++i) {
    bench.ask(kStart + i * kMillisecond, 1e-5 * i);
  }
  EXPECT_TRUE(diagnostics.waitForCount("right_secondary", "accepted", 101));  // includes the sample of the bundle
  EXPECT_EQ(diagnostics.count("right_secondary", "dropped"), 0);
  EXPECT_EQ(diagnostics.count("right_secondary", "lost before arrival"), 0);
  const auto& status = diagnostics.all().at("right_secondary");
  EXPECT_EQ(status.level, diagnostic_msgs::DiagnosticStatus::OK) << status.message;
  EXPECT_EQ(status.name, "simulate: right_secondary");
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "nominal"); }
