// The table of stiffness and loss angle over frequency, amplitude and preload.
#include "command/characteristic_table.h"

#include "support/test.h"

namespace rubber_suspension::command {
namespace {

constexpr double kCubic = 1e11;
constexpr double kLinear = 3e6;

component::Component stiffening() {
  return component::Component(
      {{"spring", {{"stiffness", {kLinear}}}}, {"progressive_stiffness", {{"cubic", {kCubic}}}}});
}

TEST(CharacteristicTable, OfALinearComponentIsItsComplexStiffnessUnderAnyPreload) {
  const component::Component component(
      {{"spring", {{"stiffness", {kLinear}}}}, {"maxwell", {{"stiffness", {1e6}}, {"break_frequency", {2.0}}}}});
  const auto table = makeTable("bush", component, {{0.5, 2.0, 10.0}, {1e-4, 1e-3}, {0.0, 5e3}});
  ASSERT_EQ(table.rows.size(), 12U);
  EXPECT_THAT(table.notes, IsEmpty());
  for (const TableRow& row : table.rows) {
    const std::complex<double> expected = *component.complexStiffness(row.point.frequency);
    EXPECT_EQ(row.complex_stiffness, expected);
    EXPECT_DOUBLE_EQ(row.point.characteristics.stiffness, std::abs(expected));
    // The loss angle is an arcsine, which is less accurate than its argument by one or two digits.
    EXPECT_NEAR(row.point.characteristics.loss_angle, std::arg(expected), 1e-12);
    EXPECT_NEAR(row.mean, row.preload / kLinear, 1e-12);  // found by iteration, to 50 bits
  }
}

component::Component elastomer(double slower) {
  return component::Component({{"spring", {{"stiffness", {kLinear}}}},
                               {"maxwell", {{"stiffness", {1e6}}, {"break_frequency", {2.0 / slower}}}},
                               {"dashpot", {{"damping", {4e3 * slower}}}},
                               {"friction", {{"maximum_force", {900.0}}, {"displacement", {4e-4}}}},
                               {"stress_softening", {{"reduction", {0.2}}, {"width", {0.5}}}}});
}

// No time scale is built in: a component that is 64 times slower has the same values at frequencies 64 times lower.
TEST(CharacteristicTable, OfASlowerComponentIsThatAtLowerFrequencies) {
  constexpr double kSlower = 64.0;
  const auto table = makeTable("bush", elastomer(1.0), {{0.5, 4.0, 30.0}, {1e-4, 2e-3}, {0.0, 5e3}});
  const auto slower =
      makeTable("bush", elastomer(kSlower), {{0.5 / kSlower, 4.0 / kSlower, 30.0 / kSlower}, {1e-4, 2e-3}, {0.0, 5e3}});
  ASSERT_EQ(table.rows.size(), slower.rows.size());
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const response::Characteristics& one = table.rows[i].point.characteristics;
    const response::Characteristics& other = slower.rows[i].point.characteristics;
    EXPECT_EQ(table.rows[i].point.settled, slower.rows[i].point.settled);
    EXPECT_NEAR(one.stiffness, other.stiffness, 1e-9 * one.stiffness);  // tolerance of a settled loop
    EXPECT_NEAR(one.loss_angle, other.loss_angle, 1e-9);
    EXPECT_NEAR(table.rows[i].mean, slower.rows[i].mean, 1e-12);
  }
}

// About a mean m, the force is k x + c((m + x)^3 - m^3). For x = A sin wt, its terms odd in x are (k + 3 c m^2) A + c
// A^3 at the turning points. The first harmonic has 3/4 c A^3 instead of c A^3.
TEST(CharacteristicTable, APreloadStiffensACubicSpring) {
  const double amplitude = 5e-4;
  const double mean = 2e-3;
  const double preload = kLinear * mean + kCubic * mean * mean * mean;
  const auto table = makeTable("bush", stiffening(), {{2.0}, {amplitude}, {0.0, preload, -preload}});
  ASSERT_EQ(table.rows.size(), 3U);
  for (const TableRow& row : table.rows) {
    const double at = row.preload == 0.0 ? 0.0 : std::copysign(mean, row.preload);
    EXPECT_NEAR(row.mean, at, 1e-12);
    const double slope = kLinear + 3.0 * kCubic * at * at;
    // The loop of 720 samples includes the turning points, so its error is rounding only.
    EXPECT_NEAR(row.point.characteristics.stiffness, slope + kCubic * amplitude * amplitude, 1e-6 * slope);
    EXPECT_NEAR(row.complex_stiffness.real(), slope + 0.75 * kCubic * amplitude * amplitude, 1e-6 * slope);
    EXPECT_NEAR(row.complex_stiffness.imag(), 0.0, 1e-6 * slope);
  }
}

TEST(CharacteristicTable, FrictionFallsWithTheAmplitudeAndIsTold) {
  const component::Component component(
      {{"spring", {{"stiffness", {kLinear}}}}, {"friction", {{"maximum_force", {5e3}}, {"displacement", {2.2e-3}}}}});
  const auto table = makeTable("bush", component, {{1.0, 10.0}, {1e-4, 1e-3, 4e-3}});
  ASSERT_EQ(table.rows.size(), 6U);
  for (std::size_t i = 0; i < 6; i += 2) {
    EXPECT_DOUBLE_EQ(table.rows[i].point.characteristics.stiffness, table.rows[i + 1].point.characteristics.stiffness);
  }
  EXPECT_GT(table.rows[0].point.characteristics.stiffness, table.rows[2].point.characteristics.stiffness);
  EXPECT_GT(table.rows[2].point.characteristics.stiffness, table.rows[4].point.characteristics.stiffness);
  EXPECT_THAT(table.notes, Contains(HasSubstr("friction depends on the path")));
  EXPECT_THAT(table.notes, Contains(HasSubstr("nonlinear")));
}

// Friction has no force at rest, and its effect on a sine does not depend on the mean displacement.
TEST(CharacteristicTable, FrictionOnALinearSpringDoesNotFeelThePreload) {
  const component::Component component(
      {{"spring", {{"stiffness", {kLinear}}}}, {"friction", {{"maximum_force", {5e3}}, {"displacement", {2.2e-3}}}}});
  const auto table = makeTable("bush", component, {{1.0}, {1e-3}, {0.0, 9e3}});
  EXPECT_NEAR(table.rows[1].mean, 3e-3, 1e-12);
  const double without = table.rows[0].point.characteristics.stiffness;
  EXPECT_NEAR(table.rows[1].point.characteristics.stiffness, without, 1e-9 * without);
  const double angle = table.rows[0].point.characteristics.loss_angle;
  EXPECT_NEAR(table.rows[1].point.characteristics.loss_angle, angle, 1e-9);
}

// About a preload, a strap behaves as if it were bonded. It cannot carry a preload with the opposite sign.
TEST(CharacteristicTable, AStrapCarriesPreloadsOfOneSign) {
  const component::Component strap({{"spring", {{"stiffness", {kLinear}}}}, {"lift_off", {{"side", {1.0}}}}});
  const auto table = makeTable("strap", strap, {{1.0}, {1e-3}, {9e3}});
  EXPECT_NEAR(table.rows[0].mean, 3e-3, 1e-12);
  EXPECT_NEAR(table.rows[0].point.characteristics.stiffness, kLinear, 1e-9 * kLinear);
  EXPECT_THAT([&] { makeTable("strap", strap, {{1.0}, {1e-3}, {-9e3}}); },
              testing::ThrowsMessage<std::invalid_argument>(HasSubstr("preload: -9000 N")));
}

TEST(CharacteristicTable, RefusesAPreloadThatNothingCarries) {
  const component::Component dashpot({{"dashpot", {{"damping", {2e4}}}}});
  EXPECT_THAT([&] { makeTable("dashpot", dashpot, {{1.0}, {1e-3}, {100.0}}); },
              testing::ThrowsMessage<std::invalid_argument>(HasSubstr("preload: 100 N")));
  EXPECT_THROW(makeTable("bush", stiffening(), {{0.0}, {1e-3}}), std::invalid_argument);
}

TEST(CharacteristicTable, CsvReadsBackToTheSameNumbers) {
  const auto table = makeTable("bush", stiffening(), {{1.0 / 3.0}, {1e-3 / 7.0}, {0.0}});
  const std::string csv = toCsv(table);
  std::istringstream lines(csv);
  std::string header;
  std::string row;
  std::getline(lines, header);
  std::getline(lines, row);
  EXPECT_EQ(header.substr(0, 25), "frequency_Hz,amplitude_m,");
  std::istringstream cells(row);
  std::string cell;
  std::vector<double> numbers;
  while (std::getline(cells, cell, ',')) {
    numbers.push_back(std::stod(cell));
  }
  ASSERT_EQ(numbers.size(), 8U);
  EXPECT_EQ(numbers[0], 1.0 / 3.0);
  EXPECT_EQ(numbers[1], 1e-3 / 7.0);
  EXPECT_EQ(numbers[4], table.rows[0].point.characteristics.stiffness);
  EXPECT_EQ(numbers[6], table.rows[0].complex_stiffness.real());
}

}  // namespace
}  // namespace rubber_suspension::command
