// What Berg's friction may add to a log that is slow and no drift.
#include "diagnosis/friction_noise.h"

#include <gtest/gtest.h>

#include "rig.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension {
namespace {

constexpr double kMaximumForce = 2e3;

std::vector<element::ElementDescription> elementsWithBerg(double displacement) {
  auto elements = rigComponent().allElements();
  elements.push_back({"friction", {{"maximum_force", {kMaximumForce}}, {"displacement", {displacement}}}});
  return elements;
}

std::vector<log::Record> records() {
  return {log::makeRecord(runRig("one", 1, [](double, double, double) { return 0.0; }))};
}

TEST(FrictionDrift, IsNoneWithoutBergsFriction) {
  EXPECT_EQ(diagnosis::frictionDrift(rigComponent().allElements(), records()), std::vector<double>{0.0});
}

// Motion of up to 2 mm slides such friction to and fro: from the first turns on, nothing tells where it came from.
TEST(FrictionDrift, IsNextToNoneWhereMotionSlides) {
  const auto logs = records();
  const double whole = kMaximumForce / logs[0].force_deviation;
  EXPECT_LT(diagnosis::frictionDrift(elementsWithBerg(1e-5), logs)[0], 0.06 * whole);
}

// Friction that 2 mm hardly move, 200 mm to half its force, is a spring: what it carries from before is a zero.
TEST(FrictionDrift, IsFarLessThanTheForceWhereFrictionHardlyMoves) {
  const auto logs = records();
  const double whole = kMaximumForce / logs[0].force_deviation;
  EXPECT_LT(diagnosis::frictionDrift(elementsWithBerg(0.2), logs)[0], 1e-3 * whole);
}

// In between it forgets in the course of the log.
TEST(FrictionDrift, IsLargestInBetween) {
  const auto logs = records();
  const double between = diagnosis::frictionDrift(elementsWithBerg(5e-3), logs)[0];
  EXPECT_GT(between, diagnosis::frictionDrift(elementsWithBerg(0.2), logs)[0]);
}

}  // namespace
}  // namespace rubber_suspension
