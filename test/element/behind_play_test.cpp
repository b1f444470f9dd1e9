// Branches behind a play: what is missing after a reversal, loss per cycle, limits.
#include <gtest/gtest.h>

#include <cmath>

#include "element/driver.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/friction_behind_play.h"
#include "rubber_suspension/element/maxwell.h"
#include "rubber_suspension/element/maxwell_behind_play.h"
#include "rubber_suspension/element/power_dashpot_behind_play.h"

namespace rubber_suspension::test {
namespace {

constexpr double kStiffness = 1e6;

TEST(FrictionBehindPlay, IsMissingOverTwiceTheGapAfterAReversal) {
  Driver driver(element::FrictionBehindPlay(kStiffness, 4e-4, 2e-4));
  EXPECT_EQ(driver.step(0.01, 1e-4), 0.0);
  EXPECT_NEAR(driver.step(0.01, 2e-3), 400.0, 1e-9) << "slides";
  EXPECT_NEAR(driver.step(0.01, 1.6e-3), 0.0, 1e-9) << "contact lost after 0.4 mm";
  EXPECT_EQ(driver.step(0.01, 1.4e-3), 0.0);
  EXPECT_NEAR(driver.step(0.01, 1.2e-3 - 1e-4), -100.0, 1e-9) << "contact on the other side after 0.4 mm more";
}

// 4 k y (A - g - y), by trapezoids of 1/4000 of the way each.
TEST(FrictionBehindPlay, LosesWhatItsFormulaSays) {
  Driver driver(element::FrictionBehindPlay(kStiffness, 4e-4, 2e-4));
  EXPECT_NEAR(settledWork(driver, 2e-3, 2, 4000), 4.0 * 400.0 * (2e-3 - 6e-4), 1e-6);
}

TEST(MaxwellBehindPlay, IsAMaxwellElementWhereTheGapIsSmall) {
  const element::Maxwell linear(kStiffness, 2.0);
  Driver driver(element::MaxwellBehindPlay(kStiffness, 2.0, 1e-15));
  Driver<element::Maxwell> reference(linear);
  for (const double z : {1e-3, 5e-4, 3e-3, -2e-3, -2e-3, 1e-4}) {
    EXPECT_NEAR(driver.step(0.05, z), reference.step(0.05, z), 1e-6);
  }
}

TEST(MaxwellBehindPlay, GivesNothingWithinTheGap) {
  Driver driver(element::MaxwellBehindPlay(kStiffness, 2.0, 1e-3));
  for (const double z : {5e-4, -9e-4, 9.9e-4}) {
    EXPECT_EQ(driver.step(0.01, z), 0.0);
  }
}

// In steady motion the dashpot moves as fast: F = k tau v; after a reversal it relaxes and then is missing.
TEST(MaxwellBehindPlay, IsADamperWithBacklash) {
  constexpr double kFrequency = 200.0;
  constexpr double kRate = 0.05;
  Driver driver(element::MaxwellBehindPlay(kStiffness, kFrequency, 1e-3));
  const double force = kStiffness * kRate / (2.0 * element::kPi * kFrequency);
  driver.step(1.0, kRate);
  EXPECT_NEAR(driver.output(), force, 1e-9);
  driver.step(0.02, kRate - 0.02 * kRate);
  EXPECT_EQ(driver.output(), 0.0) << "1 mm after the reversal";
  driver.step(0.98, 0.0);
  EXPECT_NEAR(driver.output(), -force, 1e-9);
}

constexpr element::PowerDashpotBehindPlay::Parameters kOrifice{kStiffness, 1e-4, 0.05, 2.0, 1e-3};

TEST(PowerDashpotBehindPlay, GivesNothingWithinTheGap) {
  Driver driver(element::PowerDashpotBehindPlay{kOrifice});
  for (const double z : {5e-4, -9e-4, 9.9e-4}) {
    EXPECT_EQ(driver.step(0.01, z), 0.0);
  }
}

// In steady flow F = k y (v/v_r)^p, to rounding, since the flow of a step is that at its end.
TEST(PowerDashpotBehindPlay, GrowsWithAPowerOfTheRate) {
  for (const double exponent : {0.5, 0.8, 1.0, 1.7, 2.0}) {
    for (const double rate : {0.025, 0.05, 0.1}) {
      Driver driver(element::PowerDashpotBehindPlay({kStiffness, 1e-4, 0.05, exponent, 1e-3}));
      driver.walk(2.0, 2.0 * rate, 2000);
      EXPECT_NEAR(driver.output(), kStiffness * 1e-4 * std::pow(rate / 0.05, exponent), 1e-6) << exponent;
    }
  }
}

TEST(PowerDashpotBehindPlay, IsMissingAfterAReversal) {
  Driver driver(element::PowerDashpotBehindPlay{kOrifice});
  driver.walk(1.0, 0.05, 1000);
  const double force = driver.output();
  driver.walk(0.02, 0.049, 20);
  EXPECT_EQ(driver.output(), 0.0) << "1 mm after the reversal";
  driver.walk(0.98, 0.0, 980);
  EXPECT_NEAR(driver.output(), -force, 1e-6);
}

// d' = -v_r sqrt(d/y) has sqrt(d) fall by v_r/(2 sqrt(y)) a second; the error of the implicit step is half a step of
// that rate, 2.5e-5 of 100 N over a step of 1e-6 s.
TEST(PowerDashpotBehindPlay, SlowsDownInClosedForm) {
  Driver driver(element::PowerDashpotBehindPlay{kOrifice});
  driver.walk(1.0, 0.05, 1000);
  const double z = 0.05;
  driver.walk(1e-3, z, 1000);
  EXPECT_NEAR(driver.output(), 100.0 * std::pow(1.0 - 0.05 * 1e-3 / 2e-4, 2), 0.01);
}

}  // namespace
}  // namespace rubber_suspension::test
