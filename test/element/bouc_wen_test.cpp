// Bouc-Wen hysteresis compared with closed forms for exponents 1 and 2, and with its differential equation for others.
#include "element/driver.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

constexpr double kA = 2e6;  // [N/m]

/// Integrates the differential equation over a displacement `way` with the classical Runge-Kutta method.
double integrated(double h, double way, double beta, double gamma, double n, int steps) {
  const double direction = way < 0.0 ? -1.0 : 1.0;
  const auto rate = [&](double force) {
    return kA - beta * direction * std::pow(std::abs(force), n - 1.0) * force - gamma * std::pow(std::abs(force), n);
  };
  const double dz = way / steps;
  for (int i = 0; i < steps; ++i) {
    const double first = rate(h);
    const double second = rate(h + 0.5 * dz * first);
    const double third = rate(h + 0.5 * dz * second);
    h += dz / 6.0 * (first + 2.0 * second + 2.0 * third + rate(h + dz * third));
  }
  return h;
}

// With n = 1 the force tends exponentially to A/(beta + gamma). While unloading, beta - gamma replaces the sum.
TEST(BoucWen, OfExponentOneIsExponential) {
  const double beta = 600.0;
  const double gamma = 300.0;
  Driver driver("bouc_wen stiffness=2e6 beta=600 gamma=300 exponent=1");
  const double loaded = kA / (beta + gamma) * -std::expm1(-(beta + gamma) * 1e-3);
  EXPECT_NEAR(driver.step(0.01, 1e-3), loaded, 1e-12 * loaded);
  const double unloading = beta - gamma;
  const double unloaded = (loaded + kA / unloading) * std::exp(-unloading * 2e-4) - kA / unloading;
  EXPECT_NEAR(driver.step(0.01, 8e-4), unloaded, 1e-12 * loaded);
  EXPECT_NEAR(driver.step(0.01, -1.0), -kA / (beta + gamma), 1e-12 * loaded);
}

// With n = 2 the force from rest is h_limit tanh(A z/h_limit). With beta = gamma, unloading is linear with slope A.
TEST(BoucWen, OfExponentTwoIsAHyperbolicTangent) {
  Driver driver("bouc_wen stiffness=2e6 beta=0.1 gamma=0.1 exponent=2");
  const double limit = std::sqrt(kA / 0.2);
  const double way = 1.2 * limit / kA;
  const double loaded = limit * std::tanh(1.2);
  EXPECT_NEAR(driver.step(0.01, way), loaded, 1e-6 * limit);
  EXPECT_NEAR(driver.step(0.01, 0.8 * way), loaded - 0.2 * kA * way, 1e-6 * limit);
  EXPECT_NEAR(driver.step(0.01, 100.0), limit, 1e-12 * limit);
}

// The error stays below the stated limit in single steps of any length, for exponents and asymmetries in their range.
TEST(BoucWen, IsTheEquationToTheStatedError) {
  double worst = 0.0;
  for (const double n : {1.02, 1.5, 2.0, 7.0, 20.0}) {
    for (const double ratio : {n > 2.0 ? -0.7 : -1.0, 0.0, 0.5, 1.0}) {  // without a limit the equation is stiff
      const double scale = 5e3;                                          // (A/beta)^(1/n) [N]
      const double beta = kA / std::pow(scale, n);
      Driver driver(entry("bouc_wen stiffness=2e6", {{"beta", beta}, {"gamma", ratio * beta}, {"exponent", n}}));
      double force = 0.0;
      double before = 0.0;
      for (const double z : {1e-3, 2.2e-3, 1.9e-3, -1e-3, -4e-3, 5e-3, 0.0}) {
        force = integrated(force, z - before, beta, ratio * beta, n, 20000);
        worst = std::max(worst, std::abs(driver.step(0.01, z) - force) / scale);
        before = z;
      }
    }
  }
  EXPECT_LE(worst, 1e-6);
}

}  // namespace
}  // namespace rubber_suspension::test
