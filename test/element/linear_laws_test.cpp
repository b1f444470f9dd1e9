// Maxwell element, dashpot, springpot and creep: closed forms in time and frequency, and their limits.
#include <gtest/gtest.h>

#include <boost/math/special_functions/expint.hpp>
#include <complex>

#include "element/driver.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/creep.h"
#include "rubber_suspension/element/dashpot.h"
#include "rubber_suspension/element/maxwell.h"
#include "rubber_suspension/element/spring.h"
#include "rubber_suspension/element/springpot.h"

namespace rubber_suspension::test {
namespace {

double degrees(std::complex<double> value) { return std::arg(value) * 180.0 / element::kPi; }

TEST(Maxwell, RelaxesAsAnExponential) {
  const element::Maxwell law(2e6, 1.5);
  EXPECT_DOUBLE_EQ(law.relaxationTime(), 1.0 / (2.0 * element::kPi * 1.5));
  Driver<element::Maxwell> driver(law);
  driver.step(1e-12, 1e-3);
  EXPECT_NEAR(driver.output(), 2e3, 1e-6) << "a sudden step meets the spring alone";
  EXPECT_NEAR(driver.step(0.3, 1e-3), 2e3 * std::exp(-0.3 / law.relaxationTime()), 1e-6);
}

// Under constant velocity v: F = c v (1 - exp(-t/tau)), c = k tau, in one step or in many.
TEST(Maxwell, RampIsExactAtAnyStep) {
  const element::Maxwell law(2e6, 1.5);
  const double tau = law.relaxationTime();
  for (const int steps : {1, 3, 1000}) {
    Driver<element::Maxwell> driver(law);
    driver.walk(0.5, 1e-2, steps);
    EXPECT_NEAR(driver.output(), 2e6 * tau * 0.02 * -std::expm1(-0.5 / tau), 1e-8) << steps;
  }
}

TEST(Maxwell, StepCoefficientsKeepTheirDigitsAtAnyRatio) {
  for (const double ratio : {1e-15, 1e-9, 1e-3, 1.0, 50.0, 1e3, 1e12}) {
    const element::MaxwellStep step(3.0, element::Relaxation::over(ratio));
    const double gain = ratio < 1e-5 ? 3.0 * (1.0 - 0.5 * ratio) : 3.0 * -std::expm1(-ratio) / ratio;
    EXPECT_NEAR(step.gain / gain, 1.0, 1e-10) << ratio;  // the series errs by ratio^2/6
    EXPECT_NEAR(step.decay, std::exp(-ratio), 1e-15) << ratio;
  }
}

// Polach's example (kN/mm): K_st = 3 and one element with f_b and k1 meet K = 4.2 at 4 Hz, with these loss angles.
TEST(Maxwell, MeetsThePapersExample) {
  struct Row {
    double break_frequency, stiffness, angle;
  };
  for (const Row& row : {Row{0.5, 1.2160, 2.04}, Row{1.0, 1.2638, 4.06}, Row{2.0, 1.4497, 7.94},
                         Row{4.0, 2.1264, 14.66}, Row{8.0, 4.2250, 23.73}}) {
    const std::complex<double> k =
        3.0 + *element::Maxwell(row.stiffness, row.break_frequency).complexStiffness(2.0 * element::kPi * 4.0);
    EXPECT_NEAR(std::abs(k), 4.2, 1e-4);  // the four decimals of k1
    EXPECT_NEAR(degrees(k), row.angle, 0.005 + 1e-3);
  }
}

TEST(Maxwell, LimitsAreSpringAndDashpot) {
  const double omega = 2.0 * element::kPi * 4.0;
  const std::complex<double> spring = *element::Maxwell(1e6, 1e-9).complexStiffness(omega);
  EXPECT_NEAR(std::abs(spring / 1e6 - 1.0), 0.0, 1e-9);
  const double damping = 1e4;
  const double break_frequency = 1e9;
  const std::complex<double> dashpot =
      *element::Maxwell(damping * 2.0 * element::kPi * break_frequency, break_frequency).complexStiffness(omega);
  EXPECT_NEAR(std::abs(dashpot / std::complex<double>(0.0, omega * damping) - 1.0), 0.0, 1e-8);
}

// The rate of the last step: under a sampled sine c (1 - exp(-i w dt))/dt, late by half a step.
TEST(Dashpot, SampledSineInClosedForm) {
  constexpr int kSamples = 40;
  constexpr double kDt = 0.25 / kSamples;
  const element::Dashpot law(2e4);
  Driver<element::Dashpot> driver(law);
  std::complex<double> sum = 0.0;
  for (int i = 1; i <= 2 * kSamples; ++i) {
    const double phase = 2.0 * element::kPi * i / kSamples;
    const double force = driver.step(kDt, std::sin(phase));
    sum += i > kSamples ? force * std::polar(1.0, -phase) : 0.0;
  }
  const std::complex<double> simulated = sum * std::complex<double>(0.0, 2.0 / kSamples);
  const std::complex<double> expected = 2e4 * (1.0 - std::polar(1.0, -2.0 * element::kPi / kSamples)) / kDt;
  EXPECT_NEAR(std::abs(simulated / expected - 1.0), 0.0, 1e-12);
  const std::complex<double> continuous = *law.complexStiffness(2.0 * element::kPi * 4.0);
  EXPECT_NEAR(std::arg(continuous / expected), element::kPi / kSamples, 1e-12);
}

// The rate of a parabola is exact at any step lengths; under a sine the loss stiffness errs by (w dt)^2/3 and the phase
// by (w dt)^3/4 at most.
TEST(SmoothDashpot, IsExactForAParabolaAndHasNoLag) {
  const element::SmoothDashpot law(2e4);
  Driver<element::SmoothDashpot> parabola(law);
  double t = 0.0;
  for (const double dt : {0.1, 0.02, 0.3, 0.05, 0.05}) {
    t += dt;
    const double force = parabola.step(dt, t * t);
    if (t > dt) {
      EXPECT_NEAR(force, 2e4 * 2.0 * t, 1e-9) << t;
    }
  }
  constexpr int kSamples = 100;
  Driver<element::SmoothDashpot> sine(law);
  std::complex<double> sum = 0.0;
  for (int i = 1; i <= 2 * kSamples; ++i) {
    const double phase = 2.0 * element::kPi * i / kSamples;
    const double force = sine.step(0.25 / kSamples, std::sin(phase));
    sum += i > kSamples ? force * std::polar(1.0, -phase) : 0.0;
  }
  const std::complex<double> ratio =
      sum * std::complex<double>(0.0, 2.0 / kSamples) / *law.complexStiffness(2.0 * element::kPi * 4.0);
  const double angle = 2.0 * element::kPi / kSamples;
  EXPECT_NEAR(std::abs(ratio), 1.0 + angle * angle / 3.0, std::pow(angle, 3));
  EXPECT_LE(std::abs(std::arg(ratio)), std::pow(angle, 3) / 4.0 * 1.05);
}

TEST(Springpot, HoldsToItsLawWithinTheStatedError) {
  for (const double order : {1e-6, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 1.0 - 1e-6}) {
    for (const double decades : {0.01, 1.0, 3.7, 8.0}) {
      const element::SpringpotLaw law{1e6, 4.0, order, 0.02, 0.02 * std::pow(10.0, decades)};
      const element::Springpot springpot(law);
      for (int i = 0; i <= 200; ++i) {
        const double omega = 2.0 * element::kPi * law.low_frequency * std::pow(10.0, decades * i / 200.0);
        const std::complex<double> ratio = *springpot.complexStiffness(omega) / law.complexStiffness(omega);
        ASSERT_LT(std::abs(ratio - 1.0), 1e-3) << "order " << order << " decades " << decades << " omega " << omega;
      }
    }
  }
}

TEST(Springpot, LawHasConstantLossAngle) {
  const element::SpringpotLaw law{1e6, 4.0, 0.25, 0.01, 100.0};
  EXPECT_NEAR(std::abs(law.complexStiffness(2.0 * element::kPi * 4.0)), 1e6, 1e-6);
  EXPECT_NEAR(std::abs(law.complexStiffness(2.0 * element::kPi * 64.0)), 2e6, 1e-6);
  EXPECT_NEAR(degrees(law.complexStiffness(7.0)), 22.5, 1e-9);
}

TEST(Springpot, AllElementsArePassive) {
  for (const double order : {1e-6, 0.5, 1.0 - 1e-6}) {
    const element::Springpot springpot({1e6, 4.0, order, 0.001, 1000.0});
    for (const element::Maxwell& element : springpot.elements()) {
      EXPECT_GT(element.stiffness(), 0.0);
      EXPECT_GT(element.relaxationTime(), 0.0);
    }
  }
}

// The error of the limits is that of |x^alpha - x| or |x^alpha - 1|, 1e-6 ln x, plus rounding.
TEST(Springpot, OrderZeroIsASpringOrderOneADashpot) {
  const element::Springpot almost_spring({1e6, 1.0, 1e-6, 0.01, 100.0});
  const element::Springpot almost_dashpot({1e6, 1.0, 1.0 - 1e-6, 0.01, 100.0});
  const element::Dashpot dashpot(1e6 / (2.0 * element::kPi));
  Driver<element::MaxwellBank> a(almost_spring);
  Driver<element::MaxwellBank> c(almost_dashpot);
  Driver b(element::Spring(1e6));
  Driver<element::Dashpot> d(dashpot);
  for (int i = 1; i < 200; ++i) {
    const double z = 1e-3 * std::sin(0.1 * i);
    EXPECT_NEAR(a.step(0.01, z), b.step(0.01, z), 1e-5 * 1e3);
    EXPECT_NEAR(c.step(0.01, z), d.step(0.01, z), 2e-4 * 1e3);
  }
}

// After a step of displacement the force is K_r z (2 pi f_r t)^-alpha / Gamma(1 - alpha).
TEST(Springpot, RelaxesAsAPowerOfTime) {
  const element::SpringpotLaw law{1e6, 4.0, 0.3, 0.001, 1000.0};
  const element::Springpot springpot(law);
  Driver<element::MaxwellBank> driver(springpot);
  driver.step(1e-9, 1e-3);
  double time = 0.0;
  for (const double next : {1e-3, 1e-2, 0.1, 1.0, 10.0}) {
    const double force = driver.step(next - time, 1e-3);
    time = next;
    const double expected = 1e3 * std::pow(2.0 * element::kPi * 4.0 * time, -0.3) / std::tgamma(0.7);
    EXPECT_NEAR(force / expected, 1.0, 2e-3) << time;  // the bank's error in frequency, seen in time
  }
}

TEST(Creep, ForceFallsLinearlyInTheLogarithmOfTime) {
  constexpr double kPerDecade = 2e5;
  const element::Creep law(kPerDecade, 0.1, 1e5);
  Driver<element::MaxwellBank> driver(law);
  driver.step(1e-9, 1e-3);
  EXPECT_NEAR(driver.output(), 6.0 * kPerDecade * 1e-3, 1e-3) << "six decades";
  double time = 0.0;
  double before = 0.0;
  for (double next : {1.0, 10.0, 100.0, 1e3, 1e4}) {
    const double force = driver.step(next - time, 1e-3);
    if (time > 0.0) {
      // A spectrum that is constant up to T = 1e5 s falls by S z/ln 10 (E1(t1/T) - E1(t2/T)); the bank ripples about
      // it.
      const double spectrum =
          (boost::math::expint(1, time / 1e5) - boost::math::expint(1, next / 1e5)) / std::log(10.0);
      EXPECT_NEAR(before - force, kPerDecade * 1e-3 * spectrum, 5e-3 * kPerDecade * 1e-3) << next;
      EXPECT_NEAR(before - force, kPerDecade * 1e-3, (next > 2e3 ? 0.05 : 0.01) * kPerDecade * 1e-3) << next;
    }
    time = next;
    before = force;
  }
  EXPECT_NEAR(driver.step(1e7, 1e-3), 0.0, 1e-9) << "all has relaxed";
}

}  // namespace
}  // namespace rubber_suspension::test
