// Friction that comes to its limit with the rate: its limits in closed form, and the differential equation itself.
#include "rubber_suspension/element/viscoplastic_friction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "element/driver.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/coulomb_friction.h"
#include "rubber_suspension/element/maxwell.h"

namespace rubber_suspension::test {
namespace {

constexpr double kStiffness = 1e6;
constexpr double kYield = 4e-4;
constexpr double kHalfRate = 5e-3;
constexpr double kLimit = kStiffness * kYield;

TEST(ViscoplasticFriction, HasHalfOfItsLimitAtTheHalfRate) {
  const element::ViscoplasticFriction law(kStiffness, kYield, kHalfRate);
  for (const double share : {0.1, 1.0, 9.0}) {
    for (const double side : {1.0, -1.0}) {
      Driver<element::ViscoplasticFriction> driver(law);
      // Of the transient, which decays by y/v_0 = 80 ms or faster, exp(-25) = 1e-11 is left.
      driver.walk(2.0, side * share * kHalfRate * 2.0, 2000);
      EXPECT_NEAR(driver.output(), side * kLimit * share / (1.0 + share), 1e-8 * kLimit) << side * share;
    }
  }
}

TEST(ViscoplasticFriction, IsCoulombsFrictionFarAboveTheHalfRate) {
  const element::CoulombFriction coulomb(kLimit, kStiffness);
  Driver driver(element::ViscoplasticFriction(kStiffness, kYield, 1e-12));
  Driver<element::SliderBank> reference(coulomb);
  for (const double z : {1e-4, 1e-3, 8e-4, -2e-3, 5e-4, 5.5e-4}) {
    // Where it slides, the implicit step falls short of the limit by the share v_0 dt/(dz - ...) < 1e-10.
    EXPECT_NEAR(driver.step(0.01, z), reference.step(0.01, z), 1e-8 * kLimit) << z;
  }
}

TEST(ViscoplasticFriction, IsAMaxwellElementOfSmallForce) {
  const element::Maxwell maxwell(kStiffness, kHalfRate / kYield / (2.0 * element::kPi));
  Driver driver(element::ViscoplasticFriction(kStiffness, kYield, kHalfRate));
  Driver<element::Maxwell> reference(maxwell);
  constexpr double kAmplitude = 1e-7;  // a 4000th of y
  constexpr int kSamples = 2000;
  for (int i = 1; i <= 2 * kSamples; ++i) {
    const double z = kAmplitude * std::sin(2.0 * element::kPi * i / kSamples);
    // Half a step of the implicit method, 0.5 dt/tau = 3e-3 of the force k z at most.
    EXPECT_NEAR(driver.step(0.5 / kSamples, z), reference.step(0.5 / kSamples, z), 4e-3 * kStiffness * kAmplitude);
  }
}

// Against 1e6 explicit steps over a cycle, which err by 1e-5; 4000 implicit ones err by dt v_0/y, 3e-3 of the limit.
TEST(ViscoplasticFriction, StepsSolveTheEquation) {
  Driver driver(element::ViscoplasticFriction(kStiffness, kYield, kHalfRate));
  constexpr int kSteps = 4000;
  constexpr int kParts = 250;
  constexpr double kDt = 1.0 / kSteps;
  const auto motion = [](double time) { return 3e-3 * std::sin(2.0 * element::kPi * time); };
  double force = 0.0;
  double largest = 0.0;
  for (int i = 1; i <= kSteps; ++i) {
    for (int part = 0; part < kParts; ++part) {
      const double time = (i - 1) * kDt + part * kDt / kParts;
      const double increment = motion(time + kDt / kParts) - motion(time);
      force += kStiffness * (increment - kDt / kParts * kHalfRate * force / (kLimit - std::abs(force)));
    }
    EXPECT_NEAR(driver.step(kDt, motion(i * kDt)), force, 3e-3 * kLimit) << i;
    largest = std::max(largest, driver.output());
  }
  EXPECT_GT(largest, 0.7 * kLimit) << "the motion brings it near its limit";
}

TEST(ViscoplasticFriction, StaysBelowItsLimitInAnyStep) {
  Driver driver(element::ViscoplasticFriction(kStiffness, kYield, kHalfRate));
  for (const double z : {1.0, -1e6, 3e-9, 1e6, 0.0}) {
    for (const double dt : {1e-6, 1.0, 1e6}) {
      EXPECT_LE(std::abs(driver.step(dt, z)), kLimit) << z << ' ' << dt;
    }
  }
  EXPECT_NEAR(driver.output(), 0.0, 1e-3 * kLimit) << "at rest its force is lost";
}

}  // namespace
}  // namespace rubber_suspension::test
