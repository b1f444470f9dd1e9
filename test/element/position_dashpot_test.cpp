// The dashpot whose damping grows towards one side.
#include "rubber_suspension/element/position_dashpot.h"

#include <gtest/gtest.h>

#include "element/driver.h"
#include "rubber_suspension/element/dashpot.h"

namespace rubber_suspension::test {
namespace {

constexpr double kDamping = 2e4;
constexpr double kReference = 1e-3;

TEST(PositionDashpot, GrowsTowardsItsSideByAPower) {
  const element::PositionDashpot law(kDamping, kReference, 3.0);
  EXPECT_DOUBLE_EQ(law.dampingAt(kReference), kDamping);
  EXPECT_DOUBLE_EQ(law.dampingAt(0.0), kDamping / 8.0);
  EXPECT_EQ(law.dampingAt(-kReference), 0.0);
  EXPECT_EQ(law.dampingAt(-3.0 * kReference), 0.0);
  EXPECT_DOUBLE_EQ(law.dampingAt(3.0 * kReference), 8.0 * kDamping);
  const element::PositionDashpot mirrored(kDamping, -kReference, 3.0);
  EXPECT_DOUBLE_EQ(mirrored.dampingAt(-kReference), kDamping);
}

// Both sides of power 1 are a linear dashpot.
TEST(PositionDashpot, SidesAddUpToALinearOne) {
  const element::PositionDashpot lower(kDamping, -kReference, 1.0);
  Driver a(element::PositionDashpot(kDamping, kReference, 1.0));
  Driver<element::PositionDashpot> b(lower);
  Driver c(element::SmoothDashpot{kDamping});
  for (const double z : {2e-4, 7e-4, -3e-4, -9e-4, 0.0}) {
    const double expected = c.step(0.01, z);
    EXPECT_NEAR(a.step(0.01, z) + b.step(0.01, z), expected, 1e-9);
  }
}

}  // namespace
}  // namespace rubber_suspension::test
