// Poses that a stream accepts, and poses that it drops without a change of its state.
#include "rubber_suspension/component/pose_stream.h"

#include "component/bushes.h"
#include "support/allocation_counter.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

using component::Acceptance;
using component::PoseStream;
using component::RotationMeasure;
using component::SixDirections;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr std::int64_t kMillisecond = 1000000;
constexpr double kDegree = element::kPi / 180.0;

Quaterniond turn(double degrees, const Vector3d& axis = Vector3d::UnitY()) {
  return Quaterniond(Eigen::AngleAxisd(degrees * kDegree, axis));
}

TEST(PoseStream, FollowsTheRulesForTime) {
  const SixDirections bush(fullLaws(RotationMeasure::vector));
  PoseStream stream(bush);
  const Quaterniond straight = Quaterniond::Identity();
  EXPECT_EQ(stream.push(5 * kMillisecond, {1e-3, 0.0, 0.0}, straight).acceptance, Acceptance::accepted);
  EXPECT_EQ(stream.push(5 * kMillisecond, {0.0, 0.0, 0.0}, straight).acceptance, Acceptance::repeated);
  EXPECT_EQ(stream.push(4 * kMillisecond, {0.0, 0.0, 0.0}, straight).acceptance, Acceptance::stepped_back);
  EXPECT_EQ(stream.push(900 * kMillisecond, {1e-3, 0.0, 0.0}, straight).acceptance, Acceptance::bridged);
  EXPECT_EQ(stream.push(-900 * kMillisecond, {1e-3, 0.0, 0.0}, straight).acceptance, Acceptance::restarted);
  EXPECT_EQ(stream.counters().accepted, 3U);
  EXPECT_EQ(stream.counters().dropped(), 2U);
}

TEST(PoseStream, DropsWhatIsNoPoseAndKeepsItsState) {
  const SixDirections bush(fullLaws(RotationMeasure::vector));
  PoseStream stream(bush);
  PoseStream undisturbed(bush);
  test::AllocationCounter counter;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Quaterniond longer(1.0011, 0.0, 0.0, 0.0);
  for (int i = 1; i < 50; ++i) {
    const Vector3d position(1e-5 * i, 0.0, -2e-5 * i);
    const std::int64_t stamp = i * kMillisecond;
    EXPECT_EQ(stream.push(stamp, {nan, 0.0, 0.0}, turn(1.0)).acceptance, Acceptance::not_finite);
    EXPECT_EQ(stream.push(stamp, position, Quaterniond(nan, 0.0, 0.0, 0.0)).acceptance, Acceptance::not_finite);
    EXPECT_EQ(stream.push(stamp, position, longer).acceptance, Acceptance::not_a_rotation);
    EXPECT_EQ(stream.push(stamp, position, turn(179.5)).acceptance, Acceptance::beyond_measure);
    EXPECT_EQ(stream.push(stamp, {1e300, 0.0, 0.0}, turn(1.0)).acceptance, Acceptance::force_not_finite);
    const auto answer = stream.push(stamp, position, turn(0.2 * i));
    const auto expected = undisturbed.push(stamp, position, turn(0.2 * i));
    ASSERT_EQ(answer.acceptance, Acceptance::accepted);
    ASSERT_EQ(answer.force.wrench.force, expected.force.wrench.force);
    ASSERT_EQ(answer.force.wrench.moment, expected.force.wrench.moment);
  }
  EXPECT_EQ(counter.count(), 0U);
  EXPECT_EQ(stream.counters().not_a_rotation, 49U);
  EXPECT_EQ(stream.counters().beyond_measure, 49U);
  // A quaternion is normalised if its length is within the tolerance.
  Quaterniond nearly = turn(10.0);
  nearly.coeffs() *= 1.0009;
  const auto answer = stream.push(60 * kMillisecond, Vector3d::Zero(), nearly);
  EXPECT_LT((answer.coordinates.tail<3>() - Vector3d(0.0, 10.0 * kDegree, 0.0)).norm(), 1e-14);
}

TEST(PoseStream, AnswersBeyondTheValidityAndCountsIt) {
  auto laws = fullLaws(RotationMeasure::cardan);
  laws.valid_rotation = 40.0 * kDegree;
  const SixDirections bush(laws);
  PoseStream stream(bush);
  EXPECT_FALSE(stream.push(1 * kMillisecond, Vector3d::Zero(), turn(39.0)).beyond_valid);
  EXPECT_TRUE(stream.push(2 * kMillisecond, Vector3d::Zero(), turn(41.0)).beyond_valid);
  EXPECT_EQ(stream.push(3 * kMillisecond, Vector3d::Zero(), turn(84.9)).acceptance, Acceptance::accepted);
  EXPECT_EQ(stream.push(4 * kMillisecond, Vector3d::Zero(), turn(85.1)).acceptance, Acceptance::beyond_measure);
  EXPECT_EQ(stream.push(5 * kMillisecond, Vector3d::Zero(), turn(120.0, Vector3d::UnitX())).acceptance,
            Acceptance::accepted);
  EXPECT_EQ(stream.beyondValid(), 3U);
}

TEST(PoseStream, ContinuesFromAnotherStream) {
  const SixDirections bush(coupledLaws(component::Coupling::spherical));
  PoseStream stream(bush);
  for (int i = 1; i < 20; ++i) {
    stream.push(i * kMillisecond, {1e-4 * i, 0.0, 5e-5 * i}, turn(i));
  }
  PoseStream other(bush);
  other.deserialise(stream.lastStamp(), stream.state().numbers());
  const auto expected = stream.push(20 * kMillisecond, Vector3d::Zero(), turn(3.0));
  EXPECT_EQ(other.push(20 * kMillisecond, Vector3d::Zero(), turn(3.0)).force.wrench.force, expected.force.wrench.force);
  stream.reset();
  EXPECT_FALSE(stream.started());
}

}  // namespace
}  // namespace rubber_suspension
