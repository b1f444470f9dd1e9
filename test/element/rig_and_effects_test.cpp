// What lies between rig and specimen, and what scales the specimen's force: closed forms and limits.
#include <gtest/gtest.h>

#include <complex>
#include <random>

#include "element/driver.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/dashpot.h"
#include "rubber_suspension/element/force_drift.h"
#include "rubber_suspension/element/force_offset.h"
#include "rubber_suspension/element/free_play.h"
#include "rubber_suspension/element/inertia.h"
#include "rubber_suspension/element/power_dashpot.h"
#include "rubber_suspension/element/self_heating.h"
#include "rubber_suspension/element/series_compliance.h"
#include "rubber_suspension/element/stress_softening.h"
#include "rubber_suspension/element/thinning_dashpot.h"
#include "rubber_suspension/element/time_delay.h"

namespace rubber_suspension::test {
namespace {

TEST(SeriesCompliance, HalvesAtItsClosingForceAndClosesNoMoreThanTheHyperbola) {
  const element::SeriesCompliance joint(2e7, 500.0);
  EXPECT_DOUBLE_EQ(joint.deflection(500.0), 0.5 * 500.0 / 2e7);
  EXPECT_DOUBLE_EQ(joint.deflection(-500.0), -0.5 * 500.0 / 2e7);
  EXPECT_NEAR(joint.deflection(1e-6) / (1e-6 / 2e7), 1.0, 1.01 * 1e-6 / 500.0);  // first term of the expansion
  EXPECT_NEAR(joint.deflection(5e9) / (500.0 / 2e7), 1.0, 1.01e-7);              // 1 - F_c/F of the asymptote
  EXPECT_FALSE(joint.compliance());
}

TEST(SeriesCompliance, OfOneSideYieldsToOneSignOfForceAlone) {
  const element::SeriesCompliance opens(2e7, 0.0, element::SeriesCompliance::Side::tension);
  EXPECT_DOUBLE_EQ(opens.deflection(300.0), 300.0 / 2e7);
  EXPECT_EQ(opens.deflection(-300.0), 0.0);
  EXPECT_EQ(opens.compliance()->tension, 1.0 / 2e7);
  EXPECT_EQ(opens.compliance()->compression, 0.0);
  const element::SeriesCompliance pad(2e7, 0.0, element::SeriesCompliance::Side::compression);
  EXPECT_EQ(pad.deflection(300.0), 0.0);
  EXPECT_EQ(pad.compliance()->compression, 1.0 / 2e7);
  const element::SeriesCompliance bracket(2e7);
  EXPECT_EQ(bracket.compliance()->tension, bracket.compliance()->compression);
}

TEST(SeriesCompliance, NeverYieldsLessToALargerForce) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> decade(-6.0, 9.0);
  for (int i = 0; i < 2000; ++i) {
    const element::SeriesCompliance joint(std::pow(10.0, decade(random)), std::pow(10.0, decade(random)),
                                          static_cast<element::SeriesCompliance::Side>(i % 3 - 1));
    const double force = (i % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, decade(random));
    const double larger = force + std::pow(10.0, decade(random));
    // Two roundings of F/(K_s (1 + F/F_c)), at the larger of both.
    const double rounding = 1e-15 * std::abs(joint.deflection(larger));
    ASSERT_GE(joint.deflection(larger), joint.deflection(force) - rounding) << i;
    ASSERT_GE(joint.deflection(force) * force, 0.0) << i;
  }
}

TEST(Inertia, IsExactForACubicAtUnequalSteps) {
  Driver driver(element::Inertia(12.0));
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> dt(0.01, 0.1);
  double t = 0.0;
  for (int i = 0; i < 50; ++i) {
    const double step = dt(generator);
    t += step;
    const double force = driver.step(step, t * t * (2.0 - 3.0 * t));
    if (i >= 3) {  // the start is a kink of the acceleration
      EXPECT_NEAR(force, 12.0 * (4.0 - 18.0 * t), 1e-6 * std::max(1.0, t * t * t)) << i;
    }
  }
}

TEST(Inertia, SineIsInPhaseToSecondOrder) {
  const element::Inertia law(12.0);
  constexpr int kSamples = 100;
  constexpr double kFrequency = 30.0;
  Driver<element::Inertia> driver(law);
  std::complex<double> sum = 0.0;
  for (int i = 1; i <= 2 * kSamples; ++i) {
    const double phase = 2.0 * element::kPi * i / kSamples;
    const double force = driver.step(1.0 / (kFrequency * kSamples), std::sin(phase));
    sum += i > kSamples ? force * std::polar(1.0, -phase) : 0.0;
  }
  const std::complex<double> expected = *law.complexStiffness(2.0 * element::kPi * kFrequency);
  const std::complex<double> ratio = sum * std::complex<double>(0.0, 2.0 / kSamples) / expected;
  const double step_angle = 2.0 * element::kPi / kSamples;
  EXPECT_NEAR(ratio.real() - 1.0, 11.0 / 12.0 * step_angle * step_angle, 0.01 * step_angle * step_angle);
  EXPECT_NEAR(ratio.imag(), 0.0, 2.0 * std::pow(step_angle, 3));
}

TEST(SmoothedInertia, SineIsAsItsFilterSays) {
  const element::SmoothedInertia law(12.0, 80.0);
  constexpr int kSamples = 1000;
  constexpr double kFrequency = 30.0;
  Driver<element::SmoothedInertia> driver(law);
  std::complex<double> sum = 0.0;
  for (int i = 1; i <= 3 * kSamples; ++i) {  // the lags have settled after two periods to exp(-60)
    const double phase = 2.0 * element::kPi * i / kSamples;
    const double force = driver.step(1.0 / (kFrequency * kSamples), std::sin(phase));
    sum += i > 2 * kSamples ? force * std::polar(1.0, -phase) : 0.0;
  }
  const std::complex<double> expected = *law.complexStiffness(2.0 * element::kPi * kFrequency);
  const std::complex<double> ratio = sum * std::complex<double>(0.0, 2.0 / kSamples) / expected;
  // A sine of n straight lines a period is lower by (pi/n)^2/3.
  EXPECT_NEAR(std::abs(ratio - 1.0), 0.0, 5e-6);
}

TEST(SmoothedInertia, StepsExactlyWhateverTheSteps) {
  const element::SmoothedInertia law(12.0, 5.0);
  Driver<element::SmoothedInertia> whole(law);
  Driver<element::SmoothedInertia> divided(law);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1e-3, 1e-3);
  for (int i = 0; i < 20; ++i) {
    const double to = uniform(generator);
    whole.step(0.03, to);
    divided.walk(0.03, to, 17);
    EXPECT_NEAR(divided.output(), whole.output(), 1e-9) << i;  // roundings of 1e-3 m, times m w_b^2 of 1e4 N/m
  }
}

TEST(SmoothedInertia, MakesLittleForceOfNoise) {
  constexpr double kStep = 2e-3;
  Driver driver(element::SmoothedInertia(1.0, 1.0 / (2.0 * element::kPi * kStep)));
  std::mt19937 generator(11);
  std::normal_distribution<double> noise(0.0, kStep * kStep);
  double sum = 0.0;
  constexpr int kSamples = 20000;
  for (int i = 0; i < kSamples; ++i) {
    sum += std::pow(driver.step(kStep, noise(generator)), 2);
  }
  // By the impulse response of the exact step. Five times what 20000 samples let it scatter.
  EXPECT_NEAR(std::sqrt(sum / kSamples), 0.866, 0.05 * 0.866);
}

TEST(PowerDashpot, OfPowerOneIsADashpot) {
  const element::SmoothDashpot linear(2e4);
  Driver driver(element::PowerDashpot(2e4, 0.05, 1.0));
  Driver<element::SmoothDashpot> reference(linear);
  std::mt19937 generator(13);
  std::uniform_real_distribution<double> uniform(-1e-3, 1e-3);
  for (int i = 0; i < 20; ++i) {
    const double to = uniform(generator);
    const double expected = reference.step(0.01, to);
    EXPECT_NEAR(driver.step(0.01, to), expected, 1e-9 * std::abs(expected));
  }
}

TEST(ThinningDashpot, HasALimitOfItsForce) {
  const element::ThinningDashpot law(2e4, 0.05);
  EXPECT_NEAR(law.force(1e-7), 2e4 * 1e-7, 2e4 * 1e-7 * 3e-6);  // |v|/v_h
  EXPECT_DOUBLE_EQ(law.force(0.05), 0.5 * 2e4 * 0.05);
  EXPECT_DOUBLE_EQ(law.force(-0.05), -0.5 * 2e4 * 0.05);
  EXPECT_NEAR(law.force(1e5), 2e4 * 0.05, 1e-3);
}

TEST(PowerDashpot, FollowsThePowerOfTheRate) {
  const element::PowerDashpot law(2e4, 0.05, 2.0);
  EXPECT_NEAR(law.force(0.05), 1e3, 1e-9) << "at the reference rate c v_r";
  EXPECT_NEAR(law.force(-0.1), -4e3, 1e-9);
  EXPECT_EQ(law.force(0.0), 0.0);
}

TEST(ForceOffset, IsThereFromTheStart) {
  Driver driver(element::ForceOffset(-150.0));
  EXPECT_EQ(driver.output(), -150.0);
  EXPECT_EQ(driver.step(1.0, 3e-3), -150.0);
}

TEST(ForceDrift, GrowsWithTimeAlone) {
  Driver driver(element::ForceDrift(2.5), 1e-3);
  EXPECT_EQ(driver.output(), 0.0);
  driver.step(1.0, 3e-3);
  EXPECT_DOUBLE_EQ(driver.step(3.0, -1.0), 10.0);
}

TEST(FreePlay, LeavesOutTheGap) {
  const element::FreePlay law(2e-4);
  EXPECT_EQ(law.behind(2e-4), 0.0);
  EXPECT_EQ(law.behind(-1.9e-4), 0.0);
  EXPECT_DOUBLE_EQ(law.behind(1e-3), 8e-4);
  EXPECT_DOUBLE_EQ(law.behind(-1e-3), -8e-4);
}

TEST(FreePlay, LosesAShareOfTheMotionWithinTheGap) {
  const element::FreePlay law(2e-4, 0.25);
  EXPECT_DOUBLE_EQ(law.behind(1e-4), 0.75e-4);
  EXPECT_DOUBLE_EQ(law.behind(-1e-3), -0.95e-3);
}

TEST(TimeDelay, LineIsExactAtUnequalSteps) {
  Driver driver(element::TimeDelay(7e-3));
  std::mt19937 generator(6);
  std::uniform_real_distribution<double> dt(1e-4, 4e-3);
  double t = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double step = dt(generator);
    t += step;
    EXPECT_NEAR(driver.step(step, 2.0 * t), 2.0 * std::max(0.0, t - 7e-3), 1e-12);
  }
}

// Linear in between, also where a past step was much longer than the delay.
TEST(TimeDelay, ReproducesTheBentLineBetweenSamples) {
  Driver driver(element::TimeDelay(0.05), 1.0);
  EXPECT_DOUBLE_EQ(driver.step(0.04, 2.0), 1.0) << "before the start at rest";
  EXPECT_DOUBLE_EQ(driver.step(1.0, 5.0), 5.0 - 3.0 * 0.05);
  EXPECT_NEAR(driver.step(0.02, 0.0), 5.0 - 3.0 * 0.03, 1e-12);
  EXPECT_NEAR(driver.step(0.04, 0.0), 5.0 - 5.0 * 0.01 / 0.02, 1e-12);
}

// A sampling of 20 kHz would need 1000 samples for 50 ms; the ring holds 256 and is thinned.
TEST(TimeDelay, ThinsWhereTheRingWouldBeTooShort) {
  constexpr double kDelay = 0.05;
  constexpr double kDt = 5e-5;
  constexpr double kOmega = 2.0 * element::kPi * 10.0;
  Driver driver(element::TimeDelay{kDelay});
  const double chord = std::pow(kOmega * (kDelay / 126.0), 2) / 8.0;
  for (int i = 1; i < 20000; ++i) {
    const double behind = driver.step(kDt, 1.0 - std::cos(kOmega * kDt * i));
    const double expected = 1.0 - std::cos(kOmega * std::max(0.0, kDt * i - kDelay));
    ASSERT_NEAR(behind, expected, chord + 1e-9) << i;
  }
}

TEST(TimeDelay, NegativeDelayCarriesForwardAlongALine) {
  const element::TimeDelay law(-2e-3);
  Driver<element::TimeDelay> driver(law);
  EXPECT_DOUBLE_EQ(driver.step(1e-3, 1.0), 3.0);
  EXPECT_DOUBLE_EQ(driver.step(4e-3, 3.0), 4.0);
  const double omega = 2.0 * element::kPi * 10.0;
  const std::complex<double> ideal = std::polar(1.0, omega * 2e-3);
  EXPECT_NEAR(std::abs(*law.transfer(omega) - ideal), 0.0, std::pow(omega * 2e-3, 2) / 2.0);
}

TEST(TimeDelay, NoneIsNone) {
  const element::TimeDelay law(0.0);
  Driver<element::TimeDelay> driver(law);
  EXPECT_EQ(driver.step(1e-3, 1.0), 1.0);
  EXPECT_EQ(*law.transfer(100.0), std::complex<double>(1.0, 0.0));
}

class SofteningDriver {
 public:
  explicit SofteningDriver(const element::StressSoftening& law) : law_(law) { law_.initialise(0.0, memory_); }
  double step(double z) {
    const double increment = z - z_;
    z_ = z;
    return law_.step({1.0, z, increment}, {}, memory_);
  }
  double* memory() { return memory_; }

 private:
  const element::StressSoftening& law_;
  double memory_[2] = {};
  double z_ = 0.0;
};

TEST(StressSoftening, SoftensOnlyWithinWhatWasReached) {
  const element::StressSoftening law({0.3, 0.2, 0.0});
  SofteningDriver driver(law);
  EXPECT_EQ(driver.step(1e-3), 1.0) << "first loading";
  EXPECT_EQ(driver.step(2e-3), 1.0);
  EXPECT_LT(driver.step(1e-3), 0.75) << "second loading";
  EXPECT_NEAR(driver.step(0.0), 0.7, 1e-12) << "all of the reduction";
  EXPECT_LT(driver.step(-1e-3), 0.75) << "symmetric";
  EXPECT_EQ(driver.step(2e-3), 1.0) << "regained at the largest displacement";
  EXPECT_EQ(driver.step(2.5e-3), 1.0);
}

TEST(StressSoftening, FactorIsMonotoneAndContinuous) {
  const element::StressSoftening law({0.3, 0.5, 0.0});
  double before = law.factor(0.0, 2.0);
  EXPECT_NEAR(before, 0.7, 1e-12);
  for (int i = 1; i <= 200; ++i) {
    const double factor = law.factor(0.01 * i, 2.0);
    EXPECT_GE(factor, before);
    EXPECT_LT(factor - before, 0.02);
    before = factor;
  }
  EXPECT_EQ(before, 1.0);
}

// With a = 1 and a wide transition, the reduction falls with the displacement in a straight line: tanh x = x to x^3/3.
TEST(StressSoftening, MayCountDisplacementInPlaceOfEnergy) {
  element::StressSoftening::Parameters parameters{0.3, 10.0, 0.0};
  parameters.ratio_power = 1.0;
  const element::StressSoftening law(parameters);
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    EXPECT_NEAR(law.factor(share * 2e-3, 2e-3), 1.0 - 0.3 * (1.0 - share), 0.3 * 4e-3);
  }
}

TEST(StressSoftening, PathMakesItTakeSomeCycles) {
  constexpr double kAmplitude = 1e-3;
  constexpr double kPath = 4e-3;  // one cycle of that amplitude
  const element::StressSoftening law({0.3, 0.2, kPath});
  SofteningDriver driver(law);
  driver.step(kAmplitude);
  double remaining = kAmplitude - driver.memory()[1];
  for (int cycle = 0; cycle < 5; ++cycle) {
    driver.step(-kAmplitude);
    driver.step(kAmplitude);
    const double now = kAmplitude - driver.memory()[1];
    EXPECT_NEAR(now / remaining, std::exp(-1.0), 1e-12) << cycle;
    remaining = now;
  }
}

TEST(StressSoftening, ReductionOfZeroDoesNothing) {
  const element::StressSoftening law({0.0, 0.2, 0.0});
  SofteningDriver driver(law);
  driver.step(2e-3);
  EXPECT_EQ(driver.step(1e-3), 1.0);
}

TEST(StressSoftening, StaysThroughARest) {
  const element::StressSoftening law({0.3, 0.2, 0.0});
  SofteningDriver driver(law);
  driver.step(2e-3);
  EXPECT_NEAR(law.relax(0.0, driver.memory()), 0.7, 1e-12);
  EXPECT_LT(driver.step(1e-3), 0.75);
  law.initialise(0.0, driver.memory());
  EXPECT_EQ(driver.step(1e-3), 1.0) << "a new specimen";
}

element::StressSoftening::Parameters softeningOf(double reduction, double width) { return {reduction, width, 0.0}; }

TEST(StressSoftening, GrowsWithTheReachUpToFullReach) {
  element::StressSoftening::Parameters parameters = softeningOf(0.4, 0.2);
  parameters.reach_exponent = 2.0;
  parameters.full_reach = 4e-3;
  const element::StressSoftening law(parameters);
  EXPECT_NEAR(law.factor(0.0, 2e-3), 1.0 - 0.4 * 0.25, 1e-12) << "half of the reach, a quarter of the reduction";
  EXPECT_NEAR(law.factor(0.0, 4e-3), 0.6, 1e-12);
  EXPECT_NEAR(law.factor(0.0, 8e-3), 0.6, 1e-12) << "no more beyond";
}

TEST(StressSoftening, OfOneSideLeavesTheOtherAlone) {
  element::StressSoftening::Parameters parameters = softeningOf(0.3, 0.2);
  parameters.side = element::StressSoftening::Side::upper;
  const element::StressSoftening law(parameters);
  SofteningDriver driver(law);
  EXPECT_EQ(driver.step(-3e-3), 1.0) << "does not count";
  EXPECT_EQ(driver.step(2e-3), 1.0) << "first loading to this side";
  EXPECT_LT(driver.step(1e-3), 0.75);
  EXPECT_NEAR(driver.step(0.0), 0.85, 1e-12) << "half of it at zero";
  EXPECT_EQ(driver.step(-0.6e-3), 1.0) << "beyond a quarter of the reach";
  double before = law.factor(-1e-3, 2e-3);
  for (int i = 1; i <= 300; ++i) {
    const double factor = law.factor(-1e-3 + 1e-5 * i, 2e-3);
    EXPECT_LT(std::abs(factor - before), 0.016) << "no jump: R 2/w over a 200th of the reach";
    before = factor;
  }
}

// A reach that decays by e over the recovery time; 1 s steps.
TEST(StressSoftening, RecoversAtRest) {
  element::StressSoftening::Parameters parameters = softeningOf(0.3, 0.2);
  parameters.recovery_time = 10.0;
  const element::StressSoftening law(parameters);
  SofteningDriver driver(law);
  driver.step(2e-3);
  driver.step(0.0);
  for (int i = 0; i < 9; ++i) {
    driver.step(0.0);
  }
  EXPECT_NEAR(driver.memory()[0], 2e-3 * std::exp(-1.0), 1e-12);
  EXPECT_EQ(driver.step(1e-3), 1.0) << "beyond what is left of the reach";
  EXPECT_EQ(law.relax(0.0, driver.memory()), 1.0) << "a long rest heals it";
  EXPECT_EQ(driver.memory()[0], 0.0);
}

TEST(StressSoftening, RefusesAnExponentWithoutReach) {
  EXPECT_THROW(element::makeElement({"stress_softening", {{"reduction", {0.3}}, {"reach_exponent", {1.0}}}}),
               std::invalid_argument);
  EXPECT_THROW(element::makeElement({"stress_softening", {{"reduction", {0.3}}, {"side", {0.5}}}}),
               std::invalid_argument);
}

// Constant loss force under steady motion: dx/dt = s F v (1 - x) - x/T.
TEST(SelfHeating, SettlesAtTheBalanceOfHeat) {
  const element::SelfHeating law(1e-3, 20.0);
  double memory[2];
  law.initialise(0.0, memory);
  element::ComponentForce force;
  force.friction = 1e3;
  force.elastic = 1e9;  // makes no heat
  double factor = 1.0;
  for (int i = 0; i < 100000; ++i) {
    factor = law.step({0.01, 0.0, 0.01 * 0.02}, force, memory);
  }
  const double gain = 1e-3 * 20.0 * (1e3 * 0.02);  // s T P = 0.4, of the unsoftened force
  EXPECT_NEAR(factor, 1.0 - gain / (1.0 + gain), 1e-9);
  force.friction = 0.0;
  law.step({1e-9, 0.0, 0.0}, force, memory);
  factor = law.step({20.0, 0.0, 0.0}, force, memory);
  EXPECT_NEAR(1.0 - factor, gain / (1.0 + gain) * std::exp(-1.0), 1e-6) << "cools at rest";
}

TEST(SelfHeating, TakesUpTheEnergyLostIfNothingCools) {
  const element::SelfHeating law(1e-6, 1e12);
  double memory[2];
  law.initialise(0.0, memory);
  element::ComponentForce force;
  force.viscous = 500.0;
  double factor = 1.0;
  for (int i = 0; i < 1000; ++i) {
    factor = law.step({0.01, 0.0, 1e-3}, force, memory);
  }
  // 500 N over 1 m, less half of the first step, over which the force rose from 0, softened by 2.5e-4 on average.
  EXPECT_NEAR(1.0 - factor, 1e-6 * 500.0 * 0.9995, 1e-3 * 1e-6 * 500.0);
}

TEST(SelfHeating, KeepsAFifthAtLeast) {
  const element::SelfHeating law(1e3, 1e9);
  double memory[2];
  law.initialise(0.0, memory);
  element::ComponentForce force;
  force.viscous = 1e6;
  EXPECT_EQ(law.step({1.0, 1.0, 1.0}, force, memory), element::SelfHeating::kLeastFactor);
}

}  // namespace
}  // namespace rubber_suspension::test
