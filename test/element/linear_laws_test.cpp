// Maxwell element, dashpot, springpot and creep, compared with closed forms in time and frequency and with limits.
#include <boost/math/special_functions/expint.hpp>

#include "element/driver.h"
#include "rubber_suspension/element/maxwell.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

double degrees(std::complex<double> value) { return std::arg(value) * 180.0 / element::kPi; }

TEST(Maxwell, RelaxesAsAnExponential) {
  const element::Maxwell law(2e6, 1.5);
  EXPECT_DOUBLE_EQ(law.relaxationTime(), 1.0 / (2.0 * element::kPi * 1.5));
  Driver driver(maxwell(2e6, 1.5));
  driver.step(1e-12, 1e-3);
  EXPECT_NEAR(driver.output(), 2e3, 1e-6) << "a sudden step meets the spring alone";
  EXPECT_NEAR(driver.step(0.3, 1e-3), 2e3 * std::exp(-0.3 / law.relaxationTime()), 1e-6);
}

// At constant velocity v the force is c v (1 - exp(-t/tau)), c = k tau, whether the motion takes one step or many.
TEST(Maxwell, RampIsExactAtAnyStep) {
  const double tau = 1.0 / (2.0 * element::kPi * 1.5);
  for (const int steps : {1, 3, 1000}) {
    Driver driver(maxwell(2e6, 1.5));
    driver.walk(0.5, 1e-2, steps);
    EXPECT_NEAR(driver.output(), 2e6 * tau * 0.02 * -std::expm1(-0.5 / tau), 1e-8) << steps;
  }
}

TEST(Maxwell, StepCoefficientsKeepTheirDigitsAtAnyRatio) {
  for (const double ratio : {1e-15, 1e-9, 1e-3, 1.0, 50.0, 1e3, 1e12}) {
    const element::MaxwellStep step(3.0, element::Relaxation::over(ratio));
    const double gain = ratio < 1e-5 ? 3.0 * (1.0 - 0.5 * ratio) : 3.0 * -std::expm1(-ratio) / ratio;
    EXPECT_NEAR(step.gain / gain, 1.0, 1e-10) << ratio;  // the series has an error of ratio^2/6
    EXPECT_NEAR(step.decay, std::exp(-ratio), 1e-15) << ratio;
  }
}

// In Polach's example, a spring of 3 kN/mm and an element with f_b and k1 have 4.2 kN/mm and these angles at 4 Hz.
TEST(Maxwell, MeetsThePapersExample) {
  struct Row {
    double break_frequency, stiffness, angle;
  };
  for (const Row& row : {Row{0.5, 1.2160, 2.04}, Row{1.0, 1.2638, 4.06}, Row{2.0, 1.4497, 7.94},
                         Row{4.0, 2.1264, 14.66}, Row{8.0, 4.2250, 23.73}}) {
    const std::complex<double> k =
        3.0 + *element::Maxwell(row.stiffness, row.break_frequency).complexStiffness(2.0 * element::kPi * 4.0);
    EXPECT_NEAR(std::abs(k), 4.2, 1e-4);  // k1 has four decimals
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

/// Returns the first harmonic of the force under a sine of 4 Hz, divided by the displacement and by K*.
std::complex<double> settledShare(const char* law, int samples) {
  Driver driver(law);
  const auto step = [&](double dt, double displacement) { return driver.step(dt, displacement); };
  return settledStiffness(4.0, samples, 2, 1.0, step) / *driver.law().complexStiffness(2.0 * element::kPi * 4.0);
}

// The velocity of the last step of a sampled sine gives c (1 - exp(-i w dt))/dt, which lags by half a step.
TEST(Dashpot, SampledSineInClosedForm) {
  constexpr double kAngle = 2.0 * element::kPi / 40.0;
  const std::complex<double> expected = (1.0 - std::polar(1.0, -kAngle)) / std::complex<double>(0.0, kAngle);
  EXPECT_NEAR(std::abs(settledShare("dashpot damping=2e4", 40) / expected - 1.0), 0.0, 1e-12);
  EXPECT_NEAR(std::arg(expected), -0.5 * kAngle, 1e-12);
}

// The velocity of a parabola is exact for any step lengths. Under a sine, the loss stiffness has an error of (w
// dt)^2/3, and the phase an error of at most (w dt)^3/4.
TEST(SmoothDashpot, IsExactForAParabolaAndHasNoLag) {
  Driver parabola("dashpot damping=2e4 order=2");
  double t = 0.0;
  for (const double dt : {0.1, 0.02, 0.3, 0.05, 0.05}) {
    t += dt;
    const double force = parabola.step(dt, t * t);
    if (t > dt) {
      EXPECT_NEAR(force, 2e4 * 2.0 * t, 1e-9) << t;
    }
  }
  const std::complex<double> share = settledShare("dashpot damping=2e4 order=2", 100);
  constexpr double kAngle = 2.0 * element::kPi / 100.0;
  EXPECT_NEAR(std::abs(share), 1.0 + kAngle * kAngle / 3.0, std::pow(kAngle, 3));
  EXPECT_LE(std::abs(std::arg(share)), std::pow(kAngle, 3) / 4.0 * 1.05);
}

TEST(PowerDashpot, FollowsThePowerOfTheRate) {
  for (const auto& [rate, force] : {std::pair(0.05, 1e3 /* at the reference rate c v_r */), {-0.1, -4e3}, {0.0, 0.0}}) {
    Driver driver("power_dashpot damping=2e4 reference_rate=0.05 exponent=2");
    driver.walk(1.0, rate, 100);
    EXPECT_NEAR(driver.output(), force, 1e-9) << rate;
  }
}

TEST(ThinningDashpot, HasALimitOfItsForce) {
  for (const auto& [rate, force, tolerance] : {std::tuple(1e-7, 2e4 * 1e-7, 2e4 * 1e-7 * 3e-6),  // tolerance |v|/v_h
                                               {0.05, 0.5 * 2e4 * 0.05, 1e-9},
                                               {-0.05, -0.5 * 2e4 * 0.05, 1e-9},
                                               {1e5, 2e4 * 0.05, 1e-3}}) {
    Driver driver("thinning_dashpot damping=2e4 half_rate=0.05");
    driver.walk(1.0, rate, 100);
    EXPECT_NEAR(driver.output(), force, tolerance) << rate;
  }
}

// Returns the damping at a displacement, from a steady velocity with steps far below the reference displacement.
double dampingAt(double side, double place) {
  Driver driver(entry("position_dashpot damping=2e4 reference_displacement=1e-3 power=3", {{"side", side}}),
                place - 1e-9);
  driver.walk(1e-3, place, 10);
  return driver.output() / 1e-6;
}

TEST(PositionDashpot, GrowsTowardsItsSideByAPower) {
  EXPECT_NEAR(dampingAt(1.0, 1e-3), 2e4, 1e-3);
  EXPECT_NEAR(dampingAt(1.0, 0.0), 2e4 / 8.0, 1e-3);
  EXPECT_NEAR(dampingAt(1.0, 3e-3), 2e4 * 8.0, 1e-2);
  EXPECT_EQ(dampingAt(1.0, -1e-3 - 1e-8), 0.0);
  EXPECT_EQ(dampingAt(1.0, -3e-3), 0.0);
  EXPECT_NEAR(dampingAt(-1.0, -1e-3), 2e4, 1e-3);
}

/// Returns K* of the law that a springpot approximates, K_r (i f/f_r)^alpha.
std::complex<double> springpotLaw(double order, double frequency) {
  return 1e6 * std::polar(std::pow(frequency / 4.0, order), 0.5 * element::kPi * order);
}

TEST(Springpot, HoldsToItsLawWithinTheStatedError) {
  for (const double order : {1e-6, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 1.0 - 1e-6}) {
    for (const double decades : {0.01, 1.0, 3.7, 8.0}) {
      const Law springpot = lawOf(entry("springpot stiffness=1e6 reference_frequency=4 low_frequency=0.02",
                                        {{"order", order}, {"high_frequency", 0.02 * std::pow(10.0, decades)}}));
      for (int i = 0; i <= 200; ++i) {
        const double frequency = 0.02 * std::pow(10.0, decades * i / 200.0);
        const std::complex<double> k = *springpot->complexStiffness(2.0 * element::kPi * frequency);
        ASSERT_LT(std::abs(k / springpotLaw(order, frequency) - 1.0), 1e-3)
            << "order " << order << " decades " << decades << " Hz " << frequency;
      }
    }
  }
}

TEST(Springpot, AllElementsArePassive) {
  for (const double order : {1e-6, 0.5, 1.0 - 1e-6}) {
    element::BasicLaws sum;
    ASSERT_TRUE(lawOf(entry("springpot stiffness=1e6 reference_frequency=4 low_frequency=0.001 high_frequency=1000",
                            {{"order", order}}))
                    ->addTo(sum));
    ASSERT_FALSE(sum.maxwells.empty());
    for (const auto& [stiffness, rate] : sum.maxwells) {
      EXPECT_GT(stiffness, 0.0) << order;
      EXPECT_GT(rate, 0.0) << order;
    }
  }
}

// After a step of the displacement z, the force is K_r z (2 pi f_r t)^-alpha / Gamma(1 - alpha).
TEST(Springpot, RelaxesAsAPowerOfTime) {
  Driver driver("springpot stiffness=1e6 order=0.3 reference_frequency=4 low_frequency=0.001 high_frequency=1000");
  driver.step(1e-9, 1e-3);
  double time = 0.0;
  for (const double next : {1e-3, 1e-2, 0.1, 1.0, 10.0}) {
    const double force = driver.step(next - time, 1e-3);
    time = next;
    const double expected = 1e3 * std::pow(2.0 * element::kPi * 4.0 * time, -0.3) / std::tgamma(0.7);
    EXPECT_NEAR(force / expected, 1.0, 2e-3) << time;  // error of the approximation in frequency, transformed to time
  }
}

TEST(Creep, ForceFallsLinearlyInTheLogarithmOfTime) {
  constexpr double kPerDecade = 2e5;
  Driver driver("creep stiffness_per_decade=2e5 shortest_time=0.1 longest_time=1e5");
  driver.step(1e-9, 1e-3);
  EXPECT_NEAR(driver.output(), 6.0 * kPerDecade * 1e-3, 1e-3) << "six decades";
  double time = 0.0;
  double before = 0.0;
  for (double next : {1.0, 10.0, 100.0, 1e3, 1e4}) {
    const double force = driver.step(next - time, 1e-3);
    if (time > 0.0) {
      // A spectrum S constant up to T = 1e5 s gives S z/ln 10 (E1(t1/T) - E1(t2/T)), E1 being the exponential integral.
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
