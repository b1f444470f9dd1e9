// Nonlinear springs: points of their characteristics, harmonics under a sine, limits.
#include <gtest/gtest.h>

#include <complex>
#include <stdexcept>
#include <utility>

#include "rubber_suspension/element/asymmetric_stiffness.h"
#include "rubber_suspension/element/bump_stop.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/progressive_stiffness.h"
#include "rubber_suspension/element/radial_stiffness.h"
#include "rubber_suspension/element/spring_table.h"

namespace rubber_suspension::test {
namespace {

/// Coefficient of exp(i n w t) under z = A sin wt, times 2i for n > 0: the amplitude of sin(n w t); the mean for n = 0.
/// Exact for polynomials, as 64 samples alias from harmonic 32 on.
template <class Law>
std::complex<double> harmonic(const Law& law, double amplitude, int n) {
  constexpr int kSamples = 64;
  std::complex<double> sum = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const double phase = 2.0 * element::kPi * i / kSamples;
    sum += law.force(amplitude * std::sin(phase)) * std::polar(1.0, -n * phase);
  }
  return sum / static_cast<double>(kSamples) * (n == 0 ? 1.0 : std::complex<double>(0.0, 2.0));
}

constexpr double kA = 2e-3;

TEST(ProgressiveStiffness, HarmonicsOfTheCubicTerm) {
  const element::ProgressiveStiffness law(1e11, 0.0);
  EXPECT_NEAR(harmonic(law, kA, 1).real(), 0.75 * 1e11 * kA * kA * kA, 1e-9);
  EXPECT_NEAR(harmonic(law, kA, 3).real(), -0.25 * 1e11 * kA * kA * kA, 1e-9) << "at 180 degrees";
  EXPECT_NEAR(std::abs(harmonic(law, kA, 2)), 0.0, 1e-9);
}

TEST(ProgressiveStiffness, IsOdd) {
  const element::ProgressiveStiffness law(1e11, 3e16);
  EXPECT_DOUBLE_EQ(law.force(kA), 1e11 * std::pow(kA, 3) + 3e16 * std::pow(kA, 5));
  EXPECT_EQ(law.force(-kA), -law.force(kA));
}

TEST(ProgressiveStiffness, QuadraticTermIsOddToo) {
  const element::ProgressiveStiffness law(0.0, 0.0, 2e8);
  EXPECT_DOUBLE_EQ(law.force(kA), 2e8 * kA * kA);
  EXPECT_DOUBLE_EQ(law.force(-kA), -2e8 * kA * kA);
}

TEST(ProgressiveStiffness, RefusesToBeNothing) {
  EXPECT_THROW(element::makeElement({"progressive_stiffness", {{"cubic", {0.0}}}}), std::invalid_argument);
  EXPECT_THROW(element::makeElement({"progressive_stiffness", {{"cubic", {-1.0}}}}), std::invalid_argument);
  EXPECT_NO_THROW(element::makeElement({"progressive_stiffness", {{"quintic", {1.0}}}}));
}

TEST(ProgressiveStiffness, HyperbolicSineStiffensAlikeInBothDirections) {
  const element::ProgressiveStiffness law(0.0, 0.0, 0.0, 2e5, 1e-3);
  EXPECT_NEAR(law.force(kA), 2e5 * (1e-3 * std::sinh(2.0) - kA), 1e-10);
  EXPECT_EQ(law.force(-kA), -law.force(kA));
  // Beyond 20 scales along the tangent there.
  EXPECT_NEAR(law.force(25e-3) - law.force(24e-3), 2e5 * 1e-3 * (std::cosh(20.0) - 1.0), 1e-6 * law.force(1e-2));
  EXPECT_TRUE(std::isfinite(law.force(1e3)));
}

// The gradient of W(r) - (1 - a)(W(|x|) + W(|y|)).
TEST(RadialStiffness, HasAPotential) {
  const double alone = 0.3;
  const element::RadialStiffness law(2e8, 1e11, 3e16, alone);
  const auto potential = [&](double x, double y) {
    return law.energy(std::hypot(x, y)) - (1.0 - alone) * (law.energy(std::abs(x)) + law.energy(std::abs(y)));
  };
  constexpr double kStep = 1e-7;
  for (const auto& [x, y] : {std::pair(1.5e-3, -0.7e-3), std::pair(-0.2e-3, 2e-3), std::pair(1e-3, 0.0)}) {
    const double expected = (potential(x + kStep, y) - potential(x - kStep, y)) / (2.0 * kStep);
    EXPECT_NEAR(law.force(x, y), expected, 1e-6 * std::abs(expected));
  }
}

TEST(RadialStiffness, AloneIsItsShareOfAnOddStiffening) {
  const element::ProgressiveStiffness odd(1e11, 3e16, 2e8);
  for (const double alone : {0.0, 0.4, 1.0}) {
    const element::RadialStiffness law(2e8, 1e11, 3e16, alone);
    EXPECT_NEAR(law.force(kA, 0.0), alone * odd.force(kA), 1e-9);
    EXPECT_EQ(law.force(-kA, 1e-3), -law.force(kA, -1e-3));
  }
  EXPECT_THROW(element::makeElement({"radial_stiffness", {{"alone", {0.5}}}}), std::invalid_argument);
}

TEST(ProgressiveStiffness, RefusesAnExponentialWithoutScale) {
  EXPECT_THROW(element::makeElement({"progressive_stiffness", {{"exponential", {1e5}}}}), std::invalid_argument);
  EXPECT_NO_THROW(
      element::makeElement({"progressive_stiffness", {{"exponential", {1e5}}, {"exponential_scale", {1e-3}}}}));
}

TEST(AsymmetricStiffness, ExponentialStiffensOnOneSide) {
  const element::AsymmetricStiffness upper(0.0, 0.0, {2e5, 0.0, 1e-3});
  EXPECT_NEAR(upper.force(kA), 2e5 * (1e-3 * std::expm1(2.0) - kA), 1e-10);
  EXPECT_NEAR(upper.force(-kA), 2e5 * (1e-3 * std::expm1(-2.0) + kA), 1e-10);
  const element::AsymmetricStiffness lower(0.0, 0.0, {2e5, 0.0, -1e-3});
  EXPECT_NEAR(lower.force(-kA), -upper.force(kA), 1e-10) << "the mirror image";
  EXPECT_TRUE(std::isfinite(upper.force(1e3)));
}

// Two one-sided exponentials of either sign: what is even in them, twice as much.
TEST(AsymmetricStiffness, EvenExponentialIsEven) {
  const element::AsymmetricStiffness even(0.0, 0.0, {0.0, 2e5, 1e-3});
  const element::AsymmetricStiffness upper(0.0, 0.0, {1e5, 0.0, 1e-3});
  const element::AsymmetricStiffness lower(0.0, 0.0, {1e5, 0.0, -1e-3});
  for (const double z : {1e-4, 2e-3, 0.019, 0.05}) {
    EXPECT_DOUBLE_EQ(even.force(z), even.force(-z)) << z;
    EXPECT_NEAR(even.force(z), upper.force(z) - lower.force(z), 1e-12 * std::abs(even.force(z))) << z;
  }
  EXPECT_NEAR(even.force(2e-3), 2e5 * 1e-3 * (std::cosh(2.0) - 1.0), 1e-10);
}

TEST(AsymmetricStiffness, SlopeDifferenceKeepsTheMeanSlope) {
  const element::AsymmetricStiffness law(0.0, 0.0, {}, 3e5);
  EXPECT_DOUBLE_EQ(law.force(1e-3), 150.0);
  EXPECT_DOUBLE_EQ(law.force(-1e-3), 150.0);
}

TEST(AsymmetricStiffness, RefusesAnExponentialWithoutScale) {
  EXPECT_THROW(element::makeElement({"asymmetric_stiffness", {{"exponential", {1e5}}}}), std::invalid_argument);
}

TEST(AsymmetricStiffness, HarmonicsOfTheQuadraticTerm) {
  const element::AsymmetricStiffness law(1e8, 0.0, {});
  EXPECT_NEAR(harmonic(law, kA, 0).real(), 0.5 * 1e8 * kA * kA, 1e-10);
  // z^2 = A^2/2 (1 - cos 2wt), and cos = sin a quarter later.
  EXPECT_NEAR(std::abs(harmonic(law, kA, 2)), 0.5 * 1e8 * kA * kA, 1e-10);
  EXPECT_NEAR(std::abs(harmonic(law, kA, 1)), 0.0, 1e-10);
}

TEST(AsymmetricStiffness, TensionHasASlopeOfItsOwn) {
  const element::AsymmetricStiffness law(0.0, -3e5, {});
  EXPECT_DOUBLE_EQ(law.force(1e-3), -300.0);
  EXPECT_EQ(law.force(-1e-3), 0.0);
}

TEST(BumpStop, ComesInBeyondItsGapOnly) {
  const element::BumpStop law(2e7, 1e-3, 1.0, 1e-3, element::BumpStop::Side::both);
  EXPECT_EQ(law.force(1e-3), 0.0);
  EXPECT_EQ(law.force(-0.999e-3), 0.0);
  EXPECT_NEAR(law.force(1.5e-3), 1e4, 1e-8);
  EXPECT_NEAR(law.force(-1.5e-3), -1e4, 1e-8);
}

TEST(BumpStop, ActsOnTheGivenSide) {
  const element::BumpStop upper(2e7, 1e-3, 1.0, 1e-3, element::BumpStop::Side::upper);
  const element::BumpStop lower(2e7, 1e-3, 1.0, 1e-3, element::BumpStop::Side::lower);
  EXPECT_GT(upper.force(2e-3), 0.0);
  EXPECT_EQ(upper.force(-2e-3), 0.0);
  EXPECT_EQ(lower.force(2e-3), 0.0);
  EXPECT_LT(lower.force(-2e-3), 0.0);
}

TEST(BumpStop, ExponentLeavesTheStiffnessAtTheReferenceDepth) {
  for (const double exponent : {1.0, 1.5, 2.0, 3.0}) {
    const element::BumpStop law(2e7, 1e-3, exponent, 0.5e-3, element::BumpStop::Side::both);
    EXPECT_NEAR(law.force(1.5e-3), 1e4, 1e-8) << exponent;
    EXPECT_NEAR(law.force(2.0e-3), 1e4 * std::pow(2.0, exponent), 1e-7) << exponent;
  }
}

TEST(BumpStop, WithoutGapIsASpring) {
  const element::BumpStop law(2e7, 0.0, 1.0, 1e-3, element::BumpStop::Side::both);
  EXPECT_DOUBLE_EQ(law.force(1e-4), 2e3);
  EXPECT_DOUBLE_EQ(law.force(-1e-4), -2e3);
}

TEST(BumpStop, SideIsOneOfThree) {
  EXPECT_THROW(element::makeElement({"bump_stop", {{"stiffness", {1e7}}, {"gap", {0.0}}, {"side", {0.5}}}}),
               std::invalid_argument);
}

TEST(SpringTable, InterpolatesAndGoesOnWithTheEndSlopes) {
  const element::SpringTable law({-2e-3, -1e-3, 0.0, 3e-3}, {-5e3, -1e3, 0.0, 9e3});
  EXPECT_NEAR(law.force(-1.5e-3), -3e3, 1e-9);
  EXPECT_NEAR(law.force(-1e-3), -1e3, 1e-9);
  EXPECT_NEAR(law.force(1e-3), 3e3, 1e-9);
  EXPECT_NEAR(law.force(4e-3), 12e3, 1e-9);
  EXPECT_NEAR(law.force(-3e-3), -9e3, 1e-9);
  EXPECT_EQ(law.force(0.0), 0.0);
}

TEST(SpringTable, TwoPointsAreASpring) {
  const element::SpringTable law({-1e-3, 1e-3}, {-3e3, 3e3});
  for (const double z : {-5e-3, -1e-4, 0.0, 1e-3, 7e-3}) {
    EXPECT_NEAR(law.force(z), 3e6 * z, 1e-9);
  }
}

TEST(SpringTable, RefusesTablesThatAreNone) {
  EXPECT_THROW(element::SpringTable({0.0}, {0.0}), std::invalid_argument);
  EXPECT_THROW(element::SpringTable({}, {}), std::invalid_argument);
  EXPECT_THROW(element::SpringTable({0.0, 1.0}, {0.0}), std::invalid_argument);
  EXPECT_THROW(element::SpringTable({0.0, 0.0}, {0.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(element::SpringTable({1.0, 0.0}, {0.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(element::SpringTable({0.0, 1.0}, {0.0, -1.0}), std::invalid_argument);
  EXPECT_THROW(element::SpringTable({0.0, 1.0}, {1.0, 2.0}), std::invalid_argument) << "preload";
}

}  // namespace
}  // namespace rubber_suspension::test
