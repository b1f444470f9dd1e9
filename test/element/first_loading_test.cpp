// Force of the first loading: its limit, what later loadings have of it, what a rest leaves.
#include "rubber_suspension/element/first_loading.h"

#include <gtest/gtest.h>

#include "element/driver.h"

namespace rubber_suspension::test {
namespace {

constexpr double kStiffness = 1e6;

TEST(FirstLoading, CarriesItsShareOfTheDisplacementFromZeroOn) {
  Driver driver(element::FirstLoading(kStiffness, 0.25));
  for (const double z : {1e-4, 1e-3, 2.5e-3}) {
    // d = b z/(1 + b) solves dd/dz = 1 - d/(b z).
    EXPECT_NEAR(driver.step(0.01, z), kStiffness * 0.2 * z, 1e-9);
  }
  EXPECT_NEAR(driver.step(0.01, 2e-3 + 1e-9), kStiffness * 1e-9, 1e-6) << "returns along a spring";
  EXPECT_EQ(driver.step(0.01, 1e-3), 0.0) << "nothing within what was reached";
  EXPECT_NEAR(driver.step(0.01, -1e-3), -kStiffness * 0.2e-3, 1e-9) << "the other side is new";
}

// By the equation itself, in steps of 1e-5 of the way: the first-order scheme errs by as much.
TEST(FirstLoading, FollowsItsEquationFromAReachOn) {
  Driver driver(element::FirstLoading(kStiffness, 0.1));
  driver.step(0.01, 1e-3);
  driver.step(0.01, 0.0);
  double reach = driver.memory()[0];
  constexpr double kStep = 1e-8;
  double z = reach;
  while (z < 2e-3) {
    reach += kStep * (z - reach) / (0.1 * z);
    z += kStep;
  }
  EXPECT_NEAR(driver.step(0.01, z), kStiffness * (z - reach), 1e-3 * kStiffness * (z - reach));
}

TEST(FirstLoading, IsLostWithinSomeCycles) {
  Driver driver(element::FirstLoading(kStiffness, 0.2));
  std::vector<double> peaks;
  for (int cycle = 0; cycle < 10; ++cycle) {
    peaks.push_back(driver.step(0.01, 1e-3));
    driver.step(0.01, -1e-3);
  }
  for (std::size_t i = 1; i < peaks.size(); ++i) {
    EXPECT_LT(peaks[i], peaks[i - 1]);
  }
  EXPECT_LT(peaks.back(), 0.2 * peaks.front());
}

TEST(FirstLoading, ARestKeepsTheReach) {
  const element::FirstLoading law(kStiffness, 0.2);
  Driver<element::FirstLoading> driver(law);
  driver.step(0.01, 1e-3);
  const double reach = driver.memory()[0];
  EXPECT_EQ(law.relax(0.0, driver.memory()), 0.0);
  EXPECT_EQ(driver.memory()[0], reach);
  EXPECT_EQ(law.initialise(0.0, driver.memory()), 0.0);
  EXPECT_EQ(driver.memory()[0], 0.0) << "a new test piece";
}

TEST(FirstLoading, OfOneSideLeavesTheOtherAlone) {
  Driver driver(element::FirstLoading(kStiffness, 0.2, element::FirstLoading::Side::lower));
  EXPECT_EQ(driver.step(0.01, 1e-3), 0.0);
  EXPECT_LT(driver.step(0.01, -1e-3), 0.0);
  EXPECT_THROW(element::makeElement({"first_loading", {{"stiffness", {1e6}}, {"yield_share", {0.2}}, {"side", {2.0}}}}),
               std::invalid_argument);
  EXPECT_THROW(element::makeElement({"first_loading", {{"stiffness", {1e6}}, {"yield_share", {0.2}}, {"side", {0.5}}}}),
               std::invalid_argument);
}

// A reach that each outward sample of noise moves on would take all of the force within some hundred of them.
TEST(FirstLoading, NoiseWithinTheDeadBandTakesNothing) {
  Driver driver(element::FirstLoading(kStiffness, 0.1, element::FirstLoading::Side::both, 1e-5));
  driver.step(0.01, 1e-3);
  const double force = driver.step(0.01, 0.995e-3);
  for (int i = 0; i < 1000; ++i) {
    driver.step(0.01, 0.995e-3 + (i % 2 == 0 ? 4.9e-6 : -4.9e-6));
  }
  EXPECT_EQ(driver.step(0.01, 0.995e-3), force);
  EXPECT_NEAR(force, kStiffness * 0.1 / 1.1 * 1e-3, 1e-5 * kStiffness);
}

}  // namespace
}  // namespace rubber_suspension::test
