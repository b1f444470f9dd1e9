// Master curves from rows of a table at several temperatures.
#include "fit/master_curve.h"

#include "fit/table_fit.h"
#include "rubber_suspension/element/constants.h"
#include "support/kit.h"

namespace rubber_suspension::fit {
namespace {

using element::ElementDescription;

constexpr double kReference = 20.0;  // [degC]

// Returns K* of a spring of 1 MN/m and a springpot with 1 MN/m at 1 Hz, computed directly.
std::complex<double> stiffnessAt(double frequency) {
  const double order = 0.2;
  return 1e6 + 1e6 * std::polar(std::pow(frequency, order), 0.5 * element::kPi * order);
}

// Returns a table with ten frequencies over three decades at each temperature, shifted by `decades`, with noise of K*.
std::vector<TablePoint> tableOf(const std::vector<double>& temperatures, double (*decades)(double), double noise = 0.0,
                                unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, noise);
  std::vector<TablePoint> points;
  for (const double temperature : temperatures) {
    for (int i = 0; i < 10; ++i) {
      const double frequency = std::pow(10.0, i / 3.0 - 1.0);
      std::complex<double> k = stiffnessAt(frequency * std::pow(10.0, decades(temperature)));
      if (noise > 0.0) {
        k *= std::complex<double>(1.0 + normal(random), normal(random));
      }
      points.push_back({frequency, 1e-5, std::abs(k), std::arg(k), 0.0, temperature});
    }
  }
  return points;
}

double byWlf(double temperature) { return -8.0 * (temperature - kReference) / (100.0 + temperature - kReference); }

double byArrhenius(double temperature) {  // activation energy of 150 kJ/mol
  return 150e3 / (8.314462618 * std::log(10.0)) * (1.0 / (temperature + 273.15) - 1.0 / (kReference + 273.15));
}

TEST(MasterCurve, FindsTheShiftsThatMadeTheTable) {
  const MasterCurve curve = masterCurve(tableOf({-10.0, 5.0, 20.0, 35.0, 50.0, 65.0}, byWlf), kReference);
  EXPECT_EQ(curve.law.type, "wlf_shift");
  ASSERT_EQ(curve.shifts.size(), 6U);
  for (const FoundShift& shift : curve.shifts) {
    // Two elements per decade have an error of some 2e-4 of K*. K* changes by 2 % per decade.
    EXPECT_NEAR(shift.decades, byWlf(shift.temperature), 0.02) << shift.temperature;
    EXPECT_NEAR(curve.decadesAt(shift.temperature), byWlf(shift.temperature), 0.02) << shift.temperature;
  }
  EXPECT_NEAR(curve.law.value("c1"), 8.0, 0.2);
  EXPECT_NEAR(curve.law.value("c2"), 100.0, 2.5);
  EXPECT_LT(curve.misfit, 1e-3);
}

TEST(MasterCurve, TakesArrheniusWhereThatMadeTheTable) {
  const MasterCurve curve = masterCurve(tableOf({0.0, 10.0, 20.0, 30.0, 40.0}, byArrhenius, 2e-3), kReference);
  ASSERT_EQ(curve.law.type, "arrhenius_shift");
  EXPECT_NEAR(curve.activationEnergy(), 150e3, 4.0 * curve.constants.front().deviation * 150e3);
  EXPECT_LT(curve.constants.front().deviation, 0.03);
}

// Of 100 intervals of 95 % from 20 tables, at least 89 contain the truth with a probability of 99 %. The shifts of a
// table are correlated, so the test accepts slightly fewer.
TEST(MasterCurve, IntervalsHoldTheTruth) {
  int held = 0;
  int all = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto points = tableOf({-10.0, 0.0, 10.0, 20.0, 30.0, 40.0}, byArrhenius, 3e-3, seed);
    for (const FoundShift& shift : masterCurve(points, kReference).shifts) {
      if (shift.deviation > 0.0) {
        // The shift is relative to the middle temperature, which is the reference temperature here.
        held += std::abs(shift.decades - byArrhenius(shift.temperature)) <= 1.96 * shift.deviation ? 1 : 0;
        ++all;
      }
    }
  }
  EXPECT_EQ(all, 100);
  EXPECT_GE(held, 85);
}

TEST(MasterCurve, RefusesTemperaturesThatDoNotMeet) {
  std::vector<TablePoint> points = tableOf({0.0, 40.0}, byArrhenius);
  for (TablePoint& point : points) {
    point.frequency = 1.0;
  }
  EXPECT_THAT([&] { masterCurve(points, kReference); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("neighbouring temperatures do not overlap")));
  points.front().temperature.reset();
  EXPECT_THAT([&] { masterCurve(points, kReference); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("a row has no temperature")));
  EXPECT_FALSE(leftBySuperposition(points).has_value());
}

// The shifts follow no Arrhenius law, and the stiffness falls with temperature. Still one curve fits all rows.
TEST(MasterCurve, LeavesTheNoiseOfAnyThermorheologicallySimpleTable) {
  constexpr double kNoise = 5e-3;
  std::vector<TablePoint> points = tableOf({-10.0, 5.0, 20.0, 35.0, 50.0}, byWlf, kNoise);
  for (TablePoint& point : points) {
    point.stiffness *= 1.0 - 3e-3 * (*point.temperature - kReference);
  }
  const auto left = leftBySuperposition(points);
  ASSERT_TRUE(left.has_value());
  // Both the real and the imaginary part have noise. The 50 complex numbers determine its level within 30 %.
  EXPECT_NEAR(std::sqrt(left->squares / left->free), std::sqrt(2.0) * kNoise, 0.3 * std::sqrt(2.0) * kNoise);
}

TEST(MasterCurve, BecomesAPronySeriesOrASpringpot) {
  const std::vector<TablePoint> points = tableOf({0.0, 10.0, 20.0, 30.0, 40.0}, byArrhenius);
  const io::ComponentDescription given{"bush", {spring(1e6)}};
  const TableFit pot = fitToTable(given, points, Series::springpot);
  ASSERT_TRUE(pot.master_curve.has_value());
  ASSERT_EQ(pot.component.elements().size(), 2U);
  EXPECT_NEAR(pot.component.elements()[1].value("order"), 0.2, 2e-3);
  EXPECT_NEAR(pot.component.elements()[0].value("stiffness"), 1e6, 2e4);
  const TableFit prony = fitToTable(given, points, Series::prony);
  EXPECT_LT(prony.misfit, 1e-2);  // one element per decade approximates a springpot within 1 %
  for (const TableFit& fit : {pot, prony}) {
    ASSERT_TRUE(fit.component.temperature.has_value());
    // The fitted component is evaluated at a temperature of the table with the shift that was fitted.
    const auto shifted = reducedBy(*fit.component.temperature, {points.front()});
    const auto k = fit.component.makeComponent().complexStiffness(shifted.front().frequency);
    ASSERT_TRUE(k.has_value());
    EXPECT_LT(std::abs(*k / points.front().complexStiffness() - 1.0), 1e-2);
  }
}

// Friction lowers rows with a larger amplitude. They form a curve of their own with the same shifts.
TEST(MasterCurve, KeepsAmplitudesApart) {
  std::vector<TablePoint> points = tableOf({0.0, 10.0, 20.0, 30.0}, byArrhenius);
  std::vector<TablePoint> larger = points;
  for (TablePoint& point : larger) {
    point.amplitude *= 10.0;
    point.stiffness *= 0.7;
  }
  points.insert(points.end(), larger.begin(), larger.end());
  const MasterCurve curve = masterCurve(points, kReference);
  EXPECT_NEAR(curve.activationEnergy(), 150e3, 1.5e3);
  EXPECT_LT(curve.misfit, 1e-3);
}

}  // namespace
}  // namespace rubber_suspension::fit
