// The Maxwell element that yields: limits, flow and relaxation in closed form.
#include "rubber_suspension/element/nonlinear_maxwell.h"

#include <gtest/gtest.h>

#include <random>

#include "driver.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::test {
namespace {

constexpr double kStiffness = 1e6;
constexpr double kFrequency = 2.0;
constexpr double kYield = 5e-4;

TEST(NonlinearMaxwell, IsAMaxwellElementBelowItsYield) {
  const element::NonlinearMaxwell law(kStiffness, kFrequency, 1e6);
  Driver reference(element::Maxwell(kStiffness, kFrequency));
  Driver<element::NonlinearMaxwell> driver(law);
  std::mt19937 generator(17);
  std::uniform_real_distribution<double> uniform(-1e-3, 1e-3);
  for (int i = 0; i < 50; ++i) {
    const double to = uniform(generator);
    const double expected = reference.step(0.05, to);
    EXPECT_NEAR(driver.step(0.05, to), expected, 1e-6) << "1e-9 of the largest force";
  }
}

TEST(NonlinearMaxwell, RelaxesInClosedForm) {
  Driver driver(element::NonlinearMaxwell(kStiffness, kFrequency, kYield));
  const double start = driver.step(1e-9, 2e-3);
  EXPECT_NEAR(start, 2e3, 1e-3) << "a jump is elastic";
  driver.walk(0.1, 2e-3, 2000);
  const double decay = std::exp(-0.1 * 2.0 * element::kPi * kFrequency);
  // dF/dt = -F/tau (1 + |F|/(k y)) has F = F0 e/(1 + F0/(k y) (1 - e)); the splitting errs by (dt/tau)^2 = 4e-7.
  EXPECT_NEAR(driver.output(), start * decay / (1.0 + start / (kStiffness * kYield) * (1.0 - decay)), 1e-5 * start);
}

TEST(NonlinearMaxwell, FlowsAtASteadyRate) {
  Driver driver(element::NonlinearMaxwell(kStiffness, kFrequency, kYield));
  constexpr double kRate = 0.05;
  driver.walk(2.0, kRate * 2.0, 20000);
  const double viscous = kStiffness * kRate / (2.0 * element::kPi * kFrequency);  // k tau v = F (1 + F/(k y))
  const double yield = kStiffness * kYield;
  EXPECT_NEAR(driver.output(), yield * (std::sqrt(0.25 + viscous / yield) - 0.5), 1e-4 * viscous);
}

// dF/dt = -F/tau (1 + (F/(k y))^3) has F = F0 e/(1 + (F0/(k y))^3 (1 - e^3))^(1/3), e = exp(-t/tau).
TEST(NonlinearMaxwell, RelaxesByAnyPowerInClosedForm) {
  Driver driver(element::NonlinearMaxwell(kStiffness, kFrequency, kYield, 3.0));
  const double start = driver.step(1e-9, 1e-3);
  driver.walk(0.1, 1e-3, 20000);
  const double decay = std::exp(-0.1 * 2.0 * element::kPi * kFrequency);
  const double share = std::pow(start / (kStiffness * kYield), 3);
  EXPECT_NEAR(driver.output(), start * decay / std::cbrt(1.0 + share * (1.0 - std::pow(decay, 3))), 1e-5 * start);
}

TEST(NonlinearMaxwell, ForceScalesWithStiffness) {
  const element::NonlinearMaxwell stiff(3.0 * kStiffness, kFrequency, kYield);
  Driver a(element::NonlinearMaxwell(kStiffness, kFrequency, kYield));
  Driver<element::NonlinearMaxwell> b(stiff);
  for (const double to : {1e-3, -2e-3, 5e-4, 3e-3}) {
    EXPECT_NEAR(b.step(0.02, to), 3.0 * a.step(0.02, to), 1e-9 * kStiffness);
  }
}

}  // namespace
}  // namespace rubber_suspension::test
