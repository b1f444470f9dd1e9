// The comparison of a bench's forces with a reference, for artificial forces.
#include "ros_interface/force_check.h"

#include "rubber_suspension/element/constants.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

constexpr double kOffset = 30.0;  // [N]

log::Log sineLog() {
  return logOf(
      "sine", 1000, 1000000, [](int i) { return 1e-3 * std::sin(0.02 * element::kPi * i); },
      [](int /*i*/, double z) { return 2e6 * z; });
}

ros_interface::PlayResult answered(const log::Log& log, double offset) {
  ros_interface::PlayResult result;
  for (const double force : log.force) {
    result.force.push_back({force + offset, force + offset, 0.0, 0.0});
    result.answers.push_back(1);
  }
  result.sent = log.size();
  return result;
}

// Returns the result of check_force for forces that are compared with the measured forces of the log.
ros_interface::TestCase checked(const log::Log& log, const ros_interface::PlayResult& result, double tolerance,
                                double skip = 0.0) {
  const ros_interface::ForceReference reference = ros_interface::measuredReference(log);
  return ros_interface::checkForces(log, reference, result, ros_interface::compareForces(log, reference, result, skip),
                                    tolerance);
}

TEST(ForceCheck, LeavesOutTheStart) {
  const log::Log log = sineLog();
  ros_interface::PlayResult result = answered(log, 0.0);
  result.force[99].total += 1e6;
  EXPECT_FALSE(checked(log, result, 1.0).passed);
  EXPECT_THAT(checked(log, result, 1.0).message, testing::HasSubstr("0.099 s after the start"));
  EXPECT_TRUE(checked(log, result, 0.0, 0.1).passed);
  EXPECT_THROW(checked(log, result, 0.0, 0.999), std::invalid_argument);
}

// The last axes of the figure show the difference [kN].
TEST(ForceCheck, DrawsReferenceAndBench) {
  const log::Log log = sineLog();
  const io::Figure figure =
      ros_interface::forceFigure("mount", log, ros_interface::measuredReference(log), answered(log, kOffset));
  ASSERT_EQ(figure.axes.size(), 4U);
  EXPECT_EQ(figure.axes[1].curves[0].label, "reference");
  EXPECT_EQ(figure.axes[1].curves[1].label, "bench");
  EXPECT_EQ(figure.axes[3].y_label, "reference - bench [kN]");
  EXPECT_NEAR(figure.axes[3].curves[0].y[500], -1e-3 * kOffset, 1e-9);
}

// The force has a constant offset from a sine of ten periods. So the RMS of the difference is the offset, and the
// standard deviation of the reference is the amplitude divided by the square root of two.
TEST(ForceCheck, PassesWithinTheToleranceAndFailsBeyond) {
  const log::Log log = sineLog();
  const double gap = kOffset / (2000.0 / std::sqrt(2.0));
  EXPECT_TRUE(checked(log, answered(log, kOffset), 1.001 * gap).passed);
  const ros_interface::TestCase failed = checked(log, answered(log, kOffset), 0.999 * gap);
  EXPECT_FALSE(failed.passed);
  EXPECT_THAT(failed.message, testing::HasSubstr("0.0212132 to the force measured in sine"));
  EXPECT_TRUE(checked(log, answered(log, 0.0), 0.0).passed);
}

TEST(ForceCheck, FailsWhereAForceIsMissingOrNoNumber) {
  const log::Log log = sineLog();
  ros_interface::PlayResult result = answered(log, 0.0);
  result.answers[500] = 0;
  EXPECT_FALSE(checked(log, result, 1.0).passed);
  EXPECT_FALSE(ros_interface::checkAnswers("mount", log, result).passed);
  result = answered(log, 0.0);
  result.force[500].total = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(checked(log, result, 1.0).passed);
}

TEST(ForceCheck, FailsWhereASampleIsAnsweredTwice) {
  const log::Log log = sineLog();
  ros_interface::PlayResult result = answered(log, 0.0);
  EXPECT_TRUE(ros_interface::checkAnswers("mount", log, result).passed);
  result.answers[3] = 2;
  EXPECT_THAT(ros_interface::checkAnswers("mount", log, result).message, testing::HasSubstr("more than once"));
  EXPECT_FALSE(ros_interface::checkAnswers("mount", log, result).passed);
}

TEST(ForceCheck, ReferenceOfAComponentIsItsForceOffline) {
  const log::Log log = sineLog();
  const component::Component spring({{"spring", {{"stiffness", {2e6}}}}});
  EXPECT_EQ(ros_interface::simulatedReference(spring, log, "c.yaml").force, log.force);
}

TEST(ForceCheck, SaysThatTheLogHasNoForce) {
  log::Log log = sineLog();
  log.force.clear();
  EXPECT_THROW(ros_interface::measuredReference(log), std::invalid_argument);
}

}  // namespace
}  // namespace rubber_suspension
