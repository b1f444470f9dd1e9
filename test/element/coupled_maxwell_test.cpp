// Maxwell elements that slide or break down: limits, steady motion, and the differential equation itself.
#include <gtest/gtest.h>

#include <cmath>

#include "element/driver.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/sliding_maxwell.h"
#include "rubber_suspension/element/thixotropic_maxwell.h"

namespace rubber_suspension::test {
namespace {

constexpr double kStiffness = 1e6;
constexpr double kFrequency = 2.0;
constexpr double kRelaxation = 1.0 / (2.0 * element::kPi * kFrequency);

TEST(SlidingMaxwell, IsAMaxwellElementBelowItsLimit) {
  const element::Maxwell linear(kStiffness, kFrequency);
  Driver driver(element::SlidingMaxwell(kStiffness, kFrequency, 1.0));
  Driver<element::Maxwell> reference(linear);
  for (const double z : {1e-3, -2e-3, 5e-4, 3e-3}) {
    EXPECT_EQ(driver.step(0.02, z), reference.step(0.02, z));
  }
}

TEST(SlidingMaxwell, SlidesAtItsLimitAndRelaxesBelow) {
  Driver driver(element::SlidingMaxwell(kStiffness, kFrequency, 4e-4));
  EXPECT_EQ(driver.step(1e-3, 2e-3), 400.0);
  EXPECT_NEAR(driver.step(kRelaxation, 2e-3), 400.0 * std::exp(-1.0), 1e-9);
}

// Far above the break frequency, where it does not relax, it is friction; far below it is a dashpot that never slides.
TEST(SlidingMaxwell, FrictionShowsAtHighFrequencyOnly) {
  const auto stiffness = [](double frequency, double amplitude) {
    Driver driver(element::SlidingMaxwell(kStiffness, kFrequency, 4e-4));
    double peak = 0.0;
    constexpr int kSamples = 200;
    for (int i = 0; i < 4 * kSamples; ++i) {
      const double force =
          driver.step(1.0 / (frequency * kSamples), amplitude * std::sin(2.0 * element::kPi * i / kSamples));
      peak = i > 3 * kSamples ? std::max(peak, force) : 0.0;
    }
    return peak / amplitude;
  };
  EXPECT_NEAR(stiffness(200.0, 2e-3) / stiffness(200.0, 2e-4), 0.2, 0.01) << "slides at 0.4 mm of 2 mm";
  EXPECT_NEAR(stiffness(0.1, 2e-3) / stiffness(0.1, 2e-4), 1.0, 1e-9);
}

// The structure loses 1e-14 of itself over 10 mm, less than rounding.
TEST(ThixotropicMaxwell, IsAMaxwellElementForALongTravel) {
  const element::Maxwell linear(kStiffness, kFrequency);
  Driver driver(element::ThixotropicMaxwell({kStiffness, kFrequency, 0.3, 1e12}));
  Driver<element::Maxwell> reference(linear);
  for (const double z : {1e-3, -2e-3, 5e-4, 3e-3}) {
    EXPECT_NEAR(driver.step(0.02, z), reference.step(0.02, z), 1e-8);
  }
}

// k tau v m with m = 1/(1 + v T_b/s).
TEST(ThixotropicMaxwell, SteadyFlowIsThinned) {
  Driver driver(element::ThixotropicMaxwell({kStiffness, kFrequency, 0.3, 5e-3}));
  constexpr double kRate = 0.05;
  driver.step(10.0, 10.0 * kRate);
  EXPECT_NEAR(driver.output(), kStiffness * kRelaxation * kRate / (1.0 + kRate * 0.3 / 5e-3), 1e-9);
}

// One exact step against 1e5 explicit ones, which err by 1e-5; where both rates are equal as well.
TEST(ThixotropicMaxwell, OneStepSolvesTheEquation) {
  constexpr double kTravel = 5e-3;
  constexpr double kDuration = 0.2;
  const double equal_rates = kTravel * (1.0 / kRelaxation - 1.0 / 0.3) * kDuration;
  for (const double way : {2e-3, -8e-3, equal_rates}) {
    Driver driver(element::ThixotropicMaxwell({kStiffness, kFrequency, 0.3, kTravel}));
    double force = 0.0;
    double state = 1.0;
    constexpr int kSteps = 100000;
    constexpr double kDt = kDuration / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      force += kStiffness * state * way / kSteps - kDt * force / kRelaxation;
      state += kDt * (1.0 - state) / 0.3 - state * std::abs(way) / kSteps / kTravel;
    }
    EXPECT_NEAR(driver.step(kDuration, way), force, 1e-4 * std::abs(force)) << way;
    EXPECT_NEAR(driver.memory()[1], state, 1e-4) << way;
  }
}

}  // namespace
}  // namespace rubber_suspension::test
