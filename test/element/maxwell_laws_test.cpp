// Maxwell elements that slide, break down, yield or follow a curve: steady motion, relaxation, differential equations.
#include "element/driver.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

constexpr double kStiffness = 1e6;
constexpr double kRelaxation = 1.0 / (2.0 * element::kPi * 2.0);  // relaxation time for 2 Hz [s]

// Returns the storage stiffness in the last of `cycles` cycles from Fourier's integral.
double storageStiffness(Driver& driver, double frequency, double amplitude, int cycles) {
  constexpr int kSamples = 400;
  double stiffness = 0.0;
  for (int i = 1; i <= cycles * kSamples; ++i) {
    const double sine = std::sin(2.0 * element::kPi * i / kSamples);
    const double force = driver.step(1.0 / (frequency * kSamples), amplitude * sine);
    stiffness += i > (cycles - 1) * kSamples ? 2.0 / kSamples * force * sine / amplitude : 0.0;
  }
  return stiffness;
}

TEST(SlidingMaxwell, SlidesAtItsLimitAndRelaxesBelow) {
  Driver driver("sliding_maxwell stiffness=1e6 break_frequency=2 yield_displacement=4e-4");
  EXPECT_EQ(driver.step(1e-3, 2e-3), 400.0);
  EXPECT_NEAR(driver.step(kRelaxation, 2e-3), 400.0 * std::exp(-1.0), 1e-9);
}

// Far above the break frequency, the element acts as friction. Far below, it acts as a dashpot without sliding.
TEST(SlidingMaxwell, FrictionShowsAtHighFrequencyOnly) {
  const auto stiffness = [](double frequency, double amplitude) {
    Driver driver("sliding_maxwell stiffness=1e6 break_frequency=2 yield_displacement=4e-4");
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

// One exact step agrees with 1e5 explicit steps, which have an error of 1e-5. This holds for equal rates as well.
TEST(TransientNetwork, OneStepSolvesTheEquation) {
  constexpr double kTravel = 5e-3;
  constexpr double kDuration = 0.2;
  for (const double recovery : {0.3, kRelaxation}) {
    for (const double way : {2e-3, -8e-3}) {
      Driver driver(
          entry("transient_network stiffness=1e6 break_frequency=2 travel=5e-3", {{"recovery_time", recovery}}));
      double force = 0.0;
      double intact = 1.0;
      constexpr int kSteps = 100000;
      constexpr double kDt = kDuration / kSteps;
      for (int i = 0; i < kSteps; ++i) {
        const double broken = std::abs(way) / kSteps / kTravel;
        force += kStiffness * intact * way / kSteps - (kDt / kRelaxation + broken) * force;
        intact += kDt * (1.0 - intact) / recovery - intact * broken;
      }
      EXPECT_NEAR(driver.step(kDuration, way), force, 1e-4 * std::abs(force)) << way;
      EXPECT_NEAR(driver.memory()[1], intact, 1e-4) << way;
    }
  }
}

// With the travel s, Kraus's curve K' = k/(1 + (a/a_c)^2), a_c = pi s/2, holds far above the recovery rate 1/T. The
// share of intact bonds ripples by 1/(4 pi f T) = 4 % at 1 Hz. Its second harmonic changes K' by less than 2 % of k.
TEST(PayneMaxwell, SoftensWithAmplitudeByKrausCurve) {
  constexpr double kCritical = element::kPi / 2.0 * 1e-3;
  for (const double frequency : {1.0, 8.0}) {
    for (const double amplitude : {0.3 * kCritical, kCritical, 3.0 * kCritical}) {
      Driver driver("payne_maxwell stiffness=1e6 break_frequency=0 recovery_time=2 travel=1e-3");
      const double expected = kStiffness / (1.0 + std::pow(amplitude / kCritical, 2));
      EXPECT_NEAR(storageStiffness(driver, frequency, amplitude, static_cast<int>(20.0 * frequency)), expected,
                  0.02 * kStiffness)
          << frequency << " " << amplitude;
    }
  }
}

// dF/dt = -F/tau (1 + (|F|/(k y))^p) has the solution F = F0 e/(1 + (F0/(k y))^p (1 - e^p))^(1/p), e = exp(-t/tau).
// Splitting a step in two parts has an error of (dt/tau)^2 = 4e-7.
TEST(NonlinearMaxwell, RelaxesInClosedForm) {
  for (const auto& [power, displacement, steps] : {std::tuple(1.0, 2e-3, 2000), {3.0, 1e-3, 20000}}) {
    Driver driver(entry("nonlinear_maxwell stiffness=1e6 break_frequency=2 displacement=5e-4", {{"power", power}}));
    const double start = driver.step(1e-9, displacement);
    EXPECT_NEAR(start, kStiffness * displacement, 1e-3) << "a jump is elastic";
    driver.walk(0.1, displacement, steps);
    const double decay = std::exp(-0.1 / kRelaxation);
    const double rest = 1.0 + std::pow(start / 500.0, power) * (1.0 - std::pow(decay, power));
    EXPECT_NEAR(driver.output(), start * decay / std::pow(rest, 1.0 / power), 1e-5 * start) << power;
  }
}

constexpr double kReach = 2e-3;  // [m]
constexpr double kTip = 3e6;     // stiffness at the reach [N/m]
constexpr double kGrowth = 3.0;

// Returns the stiffness at a displacement from a short step, during which the branch does not relax.
double stiffnessAt(double side, double z) {
  Driver driver(
      entry("maxwell_along_curve stiffness=3e6 displacement=2e-3 break_frequency=1e-6 growth=3", {{"side", side}}), z);
  return driver.step(1e-3, z + 1e-9) / 1e-9;
}

// Linear interpolation of the stiffness has an error of h^2 k''/8, which is at most 0.3 % here.
TEST(MaxwellAlongCurve, GrowsExponentiallyWithTheSquareOfTheDisplacement) {
  for (const double share : {-1.0, -0.5, 0.0, 0.3, 0.8}) {
    const double exact = kTip * std::exp(kGrowth * (share * share - 1.0));
    EXPECT_NEAR(stiffnessAt(0.0, share * kReach), exact, 0.003 * exact) << share;
  }
  EXPECT_NEAR(stiffnessAt(0.0, 1.5 * kReach), kTip, 1e-6 * kTip) << "constant beyond";
}

TEST(MaxwellAlongCurve, GrowsToOneSideAlone) {
  const double at_rest = kTip * std::exp(-kGrowth);
  EXPECT_NEAR(stiffnessAt(1.0, -0.8 * kReach), at_rest, 1e-3 * at_rest);
  EXPECT_GT(stiffnessAt(1.0, 0.8 * kReach), 5.0 * at_rest);
  EXPECT_NEAR(stiffnessAt(-1.0, 0.8 * kReach), at_rest, 1e-3 * at_rest);
}

}  // namespace
}  // namespace rubber_suspension::test
