// Friction whose limit varies: Coulomb's law without growth and wear, each of them in closed form.
#include "rubber_suspension/element/variable_friction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "element/driver.h"
#include "rubber_suspension/element/coulomb_friction.h"

namespace rubber_suspension::test {
namespace {

constexpr double kStiffness = 1e6;
constexpr double kYield = 4e-4;

TEST(VariableFriction, IsCoulombsWithoutGrowthAndWear) {
  const element::CoulombFriction coulomb(kStiffness * kYield, kStiffness);
  Driver driver(element::VariableFriction({kStiffness, kYield}));
  Driver<element::SliderBank> reference(coulomb);
  for (const double z : {1e-4, 1e-3, 8e-4, -2e-3, 5e-4, 5.5e-4}) {
    EXPECT_NEAR(driver.step(0.01, z), reference.step(0.01, z), 1e-9);
  }
}

TEST(VariableFriction, LimitGrowsWithDisplacementToEitherSide) {
  element::VariableFriction::Parameters parameters{kStiffness, kYield};
  parameters.growth_displacement = 1e-3;
  Driver driver{element::VariableFriction{parameters}};
  EXPECT_NEAR(driver.step(0.01, 2e-3), 3.0 * kStiffness * kYield, 1e-9);
  EXPECT_NEAR(driver.step(0.01, -4e-3), -5.0 * kStiffness * kYield, 1e-9);
}

// Slow ramps at the limit: the force falls by e along the travel, and nothing returns at rest.
TEST(VariableFriction, WearsAlongTheTravelForGood) {
  element::VariableFriction::Parameters parameters{kStiffness, kYield};
  parameters.travel = 0.05;
  const element::VariableFriction law(parameters);
  Driver<element::VariableFriction> driver(law);
  driver.step(0.01, 0.05);
  EXPECT_NEAR(driver.output(), kStiffness * kYield * std::exp(-1.0), 1e-9);
  driver.step(100.0, 0.05);
  law.relax(0.0, driver.memory());
  EXPECT_NEAR(driver.memory()[1], std::exp(-1.0), 1e-12);
}

TEST(VariableFriction, NoiseWithinTheDeadBandWearsNothing) {
  Driver driver(element::VariableFriction({kStiffness, kYield, 0.0, 0.05, 0.0, 1e-5}));
  driver.step(0.01, 0.05);
  const double worn = driver.memory()[1];
  for (int i = 0; i < 1000; ++i) {
    driver.step(0.01, 0.05 - (i % 2 == 0 ? 9e-6 : 0.0));
  }
  EXPECT_EQ(driver.memory()[1], worn);
  EXPECT_NEAR(worn, std::exp(-1.0), 1e-4);
}

// Balance of wear and build-up at a steady rate v: m = 1/(1 + v T_b/s).
TEST(VariableFriction, SettlesAtTheBalanceOfWearAndBuildUp) {
  Driver driver(element::VariableFriction({kStiffness, kYield, 0.0, 2e-3, 0.5}));
  constexpr double kRate = 0.01;
  driver.step(20.0, 20.0 * kRate);
  EXPECT_NEAR(driver.output(), kStiffness * kYield / (1.0 + kRate * 0.5 / 2e-3), 1e-9);
  driver.step(100.0, driver.displacement());
  EXPECT_NEAR(driver.memory()[1], 1.0, 1e-12) << "builds up at rest";
}

}  // namespace
}  // namespace rubber_suspension::test
