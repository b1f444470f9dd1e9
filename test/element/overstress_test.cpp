// Flow beyond a limit of the force, and the root of an implicit flow.
#include "rubber_suspension/element/overstress.h"

#include <gtest/gtest.h>

#include <cmath>

#include "element/driver.h"
#include "rubber_suspension/element/implicit_flow.h"

namespace rubber_suspension::test {
namespace {

TEST(FlowRoot, SolvesItsEquation) {
  for (const double m : {0.3, 0.5, 0.8, 1.0, 1.6, 2.0, 7.0}) {
    for (const double b : {0.0, 1e-9, 0.1, 30.0, 1e9}) {
      for (const double r : {0.0, 1e-12, 0.2, 5.0, 1e6}) {
        const double x = element::flowRoot(r, b, m);
        EXPECT_GE(x, 0.0);
        EXPECT_NEAR(x + b * std::pow(x, m), r, 1e-12 * r) << m << ' ' << b << ' ' << r;
      }
    }
  }
}

constexpr double kStiffness = 1e6;
constexpr double kYield = 2e-4;
constexpr double kRate = 0.01;

TEST(Overstress, IsElasticBelowItsLimit) {
  Driver driver(element::Overstress({kStiffness, kYield, kRate, 2.0}));
  for (const double z : {1e-4, 1.9e-4, -1.5e-4, 0.0}) {
    EXPECT_NEAR(driver.step(1e3, z), kStiffness * z, 1e-9);
  }
}

TEST(Overstress, FlowsAtASteadyRate) {
  for (const double power : {1.0, 2.0, 3.5}) {
    for (const double rate : {1e-3, 0.01, 0.3}) {
      Driver driver(element::Overstress({kStiffness, kYield, kRate, power}));
      driver.walk(10.0, 10.0 * rate, 4000);
      const double expected = kStiffness * kYield * (1.0 + std::pow(rate / kRate, 1.0 / power));
      EXPECT_NEAR(driver.output(), expected, 1e-4 * expected) << power << ' ' << rate;
    }
  }
}

TEST(Overstress, KeepsItsLimitInAHold) {
  Driver driver(element::Overstress({kStiffness, kYield, kRate, 2.0}));
  driver.walk(1.0, 0.01, 1000);
  driver.walk(1e4, 0.01, 1000);  // x' = -v_r/y x^2 leaves y/(v_r t) = 2e-6 of the limit
  EXPECT_NEAR(driver.output(), kStiffness * kYield, 1e-5 * kStiffness * kYield);
}

}  // namespace
}  // namespace rubber_suspension::test
