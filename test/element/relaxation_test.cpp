// Relaxation over a step agrees with an exponential in extended precision.
#include "rubber_suspension/element/relaxation.h"

#include "support/test.h"

namespace rubber_suspension::test {
namespace {

// The error of a few roundings of 1.1e-16, and of some more in the polynomial.
constexpr double kStated = 4e-16;

void expectExact(double x) {
  const element::Relaxation relaxation = element::Relaxation::over(x);
  const long double decay = std::exp(-static_cast<long double>(x));
  const long double mean = -std::expm1(-static_cast<long double>(x)) / x;
  // A small decay factor is 1 minus the relaxed share, so it has the absolute rounding error of 1.
  EXPECT_NEAR(static_cast<double>(relaxation.decay - decay), 0.0, kStated * std::max(0.5, static_cast<double>(decay)))
      << x;
  EXPECT_NEAR(static_cast<double>(relaxation.mean / mean - 1.0L), 0.0, kStated) << x;
}

TEST(Relaxation, IsExactWithinItsStatedError) {
  for (int i = 0; i <= 20000; ++i) {
    expectExact(element::Relaxation::kSmall * (i + 1) / 20000.0);  // small arguments, and arguments just above
    expectExact(1e-18 * std::pow(1e22, i / 20000.0));              // arguments from 1e-18 to 1e4
  }
}

TEST(Relaxation, OfSmallStepsIsTheSameByEitherName) {
  for (int i = 1; i <= 1000; ++i) {
    const double x = element::Relaxation::kSmall * i / 1000.0;
    EXPECT_EQ(element::Relaxation::over(x).decay, element::Relaxation::small(x).decay);
    EXPECT_EQ(element::Relaxation::over(x).mean, element::Relaxation::small(x).mean);
  }
}

TEST(Relaxation, OfStepsThatVanishOrNeverEnd) {
  EXPECT_EQ(element::Relaxation::over(1e-300).decay, 1.0);
  EXPECT_EQ(element::Relaxation::over(1e-300).mean, 1.0);
  EXPECT_EQ(element::Relaxation::over(1e6).decay, 0.0);
  EXPECT_EQ(element::Relaxation::over(1e6).mean, 1e-6);
}

}  // namespace
}  // namespace rubber_suspension::test
