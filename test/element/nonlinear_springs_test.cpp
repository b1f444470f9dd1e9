// Nonlinear springs: points of their characteristics, harmonics under a sine, and limits.
#include "element/driver.h"
#include "rubber_suspension/element/radial_stiffness.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

constexpr double kA = 2e-3;

/// The expected force [N] at a displacement [m], with its tolerance [N].
struct Point {
  double displacement;
  double force;
  double tolerance = 1e-12;  // rounding of forces of some kN
};

struct Characteristic {
  std::string name;
  std::string law;
  std::vector<Point> points;
};

const std::string kTable = "spring_table displacement=-2e-3,-1e-3,0,3e-3 force=-5e3,-1e3,0,9e3";

const std::vector<Characteristic> kCharacteristics = {
    {"cubic_and_quintic",
     "progressive_stiffness cubic=1e11 quintic=3e16",
     {{kA, 1e11 * std::pow(kA, 3) + 3e16 * std::pow(kA, 5)}, {-kA, -1e11 * std::pow(kA, 3) - 3e16 * std::pow(kA, 5)}}},
    {"quadratic_is_odd_too", "progressive_stiffness quadratic=2e8", {{kA, 2e8 * kA* kA}, {-kA, -2e8 * kA* kA}}},
    {"hyperbolic_sine",
     "progressive_stiffness exponential=2e5 exponential_scale=1e-3",
     {{kA, 2e5 * (1e-3 * std::sinh(2.0) - kA), 1e-10}, {-kA, -2e5 * (1e-3 * std::sinh(2.0) - kA), 1e-10}}},
    {"exponential_to_one_side",
     "asymmetric_stiffness exponential=2e5 exponential_scale=1e-3",
     {{kA, 2e5 * (1e-3 * std::expm1(2.0) - kA), 1e-10}, {-kA, 2e5 * (1e-3 * std::expm1(-2.0) + kA), 1e-10}}},
    {"exponential_to_the_other_side",
     "asymmetric_stiffness exponential=2e5 exponential_scale=-1e-3",
     {{-kA, -2e5 * (1e-3 * std::expm1(2.0) - kA), 1e-10}}},
    {"even_exponential",
     "asymmetric_stiffness even_exponential=2e5 exponential_scale=1e-3",
     {{kA, 2e5 * 1e-3 * (std::cosh(2.0) - 1.0), 1e-10}}},
    {"slope_difference_keeps_the_mean_slope",
     "asymmetric_stiffness slope_difference=3e5",
     {{1e-3, 150.0}, {-1e-3, 150.0}}},
    {"tension_has_a_slope_of_its_own",
     "asymmetric_stiffness tension_stiffness=-3e5",
     {{1e-3, -300.0}, {-1e-3, 0.0, 0.0}}},
    {"stop_beyond_its_gap",
     "bump_stop stiffness=2e7 gap=1e-3 exponent=1",
     {{1e-3, 0.0, 0.0}, {-0.999e-3, 0.0, 0.0}, {1.5e-3, 1e4, 1e-8}, {-1.5e-3, -1e4, 1e-8}}},
    {"stop_above", "bump_stop stiffness=2e7 gap=1e-3 exponent=1 side=1", {{2e-3, 2e4, 1e-8}, {-2e-3, 0.0, 0.0}}},
    {"stop_below", "bump_stop stiffness=2e7 gap=1e-3 exponent=1 side=-1", {{2e-3, 0.0, 0.0}, {-2e-3, -2e4, 1e-8}}},
    // The exponent does not change the stiffness at the reference depth.
    {"stop_of_exponent_1_5",
     "bump_stop stiffness=2e7 gap=1e-3 reference_depth=0.5e-3 exponent=1.5",
     {{1.5e-3, 1e4, 1e-8}, {2.0e-3, 1e4 * std::pow(2.0, 1.5), 1e-7}}},
    {"stop_of_exponent_2",
     "bump_stop stiffness=2e7 gap=1e-3 reference_depth=0.5e-3 exponent=2",
     {{1.5e-3, 1e4, 1e-8}, {2.0e-3, 4e4, 1e-7}}},
    {"stop_of_exponent_3",
     "bump_stop stiffness=2e7 gap=1e-3 reference_depth=0.5e-3 exponent=3",
     {{1.5e-3, 1e4, 1e-8}, {2.0e-3, 8e4, 1e-7}}},
    {"table_between_its_points", kTable, {{-1.5e-3, -3e3, 1e-9}, {1e-3, 3e3, 1e-9}}},
    {"table_at_its_points", kTable, {{-1e-3, -1e3, 1e-9}, {0.0, 0.0, 0.0}}},
    {"table_goes_on_with_its_end_slopes", kTable, {{4e-3, 12e3, 1e-9}, {-3e-3, -9e3, 1e-9}}}};

class SpringOf : public testing::TestWithParam<Characteristic> {};
INSTANTIATE_TEST_SUITE_P(Characteristics, SpringOf, testing::ValuesIn(kCharacteristics),
                         [](const auto& test) { return test.param.name; });

TEST_P(SpringOf, HasItsPoints) {
  const Law law = lawOf(GetParam().law);
  for (const Point& point : GetParam().points) {
    EXPECT_NEAR(forceAt(law, point.displacement), point.force, point.tolerance) << point.displacement;
  }
}

/// Returns the amplitude of sin(n w t) in the force under z = A sin wt, as 2i times the coefficient of exp(i n w t), or
/// the mean force for n = 0. It is exact for polynomials, because 64 samples alias from harmonic 32 on.
std::complex<double> harmonic(const Law& law, int n) {
  constexpr int kSamples = 64;
  std::complex<double> sum = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const double phase = 2.0 * element::kPi * i / kSamples;
    sum += forceAt(law, kA * std::sin(phase)) * std::polar(1.0, -n * phase);
  }
  return sum / static_cast<double>(kSamples) * (n == 0 ? 1.0 : std::complex<double>(0.0, 2.0));
}

TEST(Harmonics, OfTheCubicTerm) {
  const Law law = lawOf("progressive_stiffness cubic=1e11");
  EXPECT_NEAR(harmonic(law, 1).real(), 0.75 * 1e11 * kA * kA * kA, 1e-9);
  EXPECT_NEAR(harmonic(law, 3).real(), -0.25 * 1e11 * kA * kA * kA, 1e-9) << "at 180 degrees";
  EXPECT_NEAR(std::abs(harmonic(law, 2)), 0.0, 1e-9);
}

TEST(Harmonics, OfTheQuadraticTerm) {
  const Law law = lawOf("asymmetric_stiffness quadratic=1e8");
  EXPECT_NEAR(harmonic(law, 0).real(), 0.5 * 1e8 * kA * kA, 1e-10);
  // With z^2 = A^2/2 (1 - cos 2wt), the second harmonic is a sine shifted by a quarter period.
  EXPECT_NEAR(std::abs(harmonic(law, 2)), 0.5 * 1e8 * kA * kA, 1e-10);
  EXPECT_NEAR(std::abs(harmonic(law, 1)), 0.0, 1e-10);
}

// Beyond 20 scales the force continues along its tangent.
TEST(Exponentials, StayFinite) {
  const Law law = lawOf("progressive_stiffness exponential=2e5 exponential_scale=1e-3");
  EXPECT_NEAR(forceAt(law, 25e-3) - forceAt(law, 24e-3), 2e5 * 1e-3 * (std::cosh(20.0) - 1.0),
              1e-6 * forceAt(law, 1e-2));
  EXPECT_TRUE(std::isfinite(forceAt(law, 1e3)));
  EXPECT_TRUE(std::isfinite(forceAt(lawOf("asymmetric_stiffness exponential=2e5 exponential_scale=1e-3"), 1e3)));
}

// The even exponential is the sum of two one-sided exponentials with opposite scales.
TEST(AsymmetricStiffness, EvenExponentialIsEven) {
  const Law even = lawOf("asymmetric_stiffness even_exponential=2e5 exponential_scale=1e-3");
  const Law upper = lawOf("asymmetric_stiffness exponential=1e5 exponential_scale=1e-3");
  const Law lower = lawOf("asymmetric_stiffness exponential=1e5 exponential_scale=-1e-3");
  for (const double z : {1e-4, 2e-3, 0.019, 0.05}) {
    EXPECT_DOUBLE_EQ(forceAt(even, z), forceAt(even, -z)) << z;
    EXPECT_NEAR(forceAt(even, z), forceAt(upper, z) - forceAt(lower, z), 1e-12 * std::abs(forceAt(even, z))) << z;
  }
}

// The force is the gradient of W(r) - (1 - a)(W(|x|) + W(|y|)). W is the energy of a spring, and a is `alone`.
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
  const Law odd = lawOf("progressive_stiffness cubic=1e11 quintic=3e16 quadratic=2e8");
  for (const double alone : {0.0, 0.4, 1.0}) {
    const element::RadialStiffness law(2e8, 1e11, 3e16, alone);
    EXPECT_NEAR(law.force(kA, 0.0), alone * forceAt(odd, kA), 1e-9);
    EXPECT_EQ(law.force(-kA, 1e-3), -law.force(kA, -1e-3));
  }
}

}  // namespace
}  // namespace rubber_suspension::test
