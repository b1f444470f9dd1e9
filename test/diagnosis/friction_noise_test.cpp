// Error of Berg's friction because the motion before the log is unknown.
#include "measurement/friction_noise.h"

#include <Eigen/Core>

#include "rig.h"
#include "rubber_suspension/log/record.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr double kMaximumForce = 2e3;

std::vector<element::ElementDescription> elementsWithBerg(double displacement) {
  auto elements = rigComponent().allElements();
  elements.push_back(friction(kMaximumForce, displacement));
  return elements;
}

std::vector<gap::PreparedRecord> records() { return {log::makeRecord(runRig("one", 1, nothing))}; }

double deviation(const Eigen::VectorXd& values) { return std::sqrt((values.array() - values.mean()).square().mean()); }

// Returns the RMS of the initial friction force that decays within the log, divided by the maximum friction force.
double forgotten(double displacement) {
  const Eigen::MatrixXd starts = measurement::frictionStarts(elementsWithBerg(displacement), records())[0];
  return std::max(deviation(starts.col(0)), deviation(starts.col(1))) / kMaximumForce;
}

TEST(FrictionStarts, AreNoneWithoutBergsFriction) {
  EXPECT_EQ(measurement::frictionStarts(rigComponent().allElements(), records())[0].cols(), 0);
}

TEST(FrictionStarts, AreNoneWhereThePastIsKnown) {
  auto logs = records();
  logs[0].lead_in.displacement = {0.0, 0.0, 0.0};
  EXPECT_EQ(measurement::frictionStarts(elementsWithBerg(5e-3), logs)[0].cols(), 0);
}

// At 0.01 mm friction has half of its maximum force. Motion of up to 2 mm slides, so friction soon forgets its start.
TEST(FrictionStarts, AreNextToNoneWhereMotionSlides) { EXPECT_LT(forgotten(1e-5), 0.06); }

// If friction has half of its maximum force at 200 mm, it acts as a spring. Its initial force is a constant offset.
TEST(FrictionStarts, AreAZeroWhereFrictionHardlyMoves) { EXPECT_LT(forgotten(0.2), 1e-3); }

// For a displacement in between, the initial force decays within the log.
TEST(FrictionStarts, AreLargestInBetween) { EXPECT_GT(forgotten(5e-3), forgotten(0.2)); }

}  // namespace
}  // namespace rubber_suspension
