// Temperature laws agree with published constants: shift factors, other references, validity.
#include "rubber_suspension/element/catalogue.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

using Shift = std::shared_ptr<const element::TemperatureShift>;

Shift shiftOf(const element::ElementDescription& description) {
  return std::get<Shift>(element::makeElement(description));
}

Shift wlf(double c1, double c2, double reference) {
  return shiftOf(entry("wlf_shift", {{"c1", c1}, {"c2", c2}, {"reference", reference}}));
}

Shift arrhenius(double energy, double reference) {
  return shiftOf(entry("arrhenius_shift", {{"activation_energy", energy}, {"reference", reference}}));
}

double decades(const Shift& shift, double temperature) { return std::log10(shift->at(temperature).time); }

// The universal constants at the glass transition, here 0 degC, are of M. L. Williams, R. F. Landel, J. D. Ferry, J.
// Am. Chem. Soc. 77 (1955) 3701. By hand, -17.44 50/(51.6 + 50) = -872/101.6, and the others likewise.
TEST(WlfShift, UniversalConstantsAtTheGlassTransition) {
  const Shift shift = wlf(17.44, 51.6, 0.0);
  EXPECT_DOUBLE_EQ(shift->at(0.0).time, 1.0);
  EXPECT_NEAR(decades(shift, 50.0), -8.582677165354331, 1e-13);
  EXPECT_NEAR(decades(shift, 10.0), -2.831168831168831, 1e-13);
  EXPECT_NEAR(decades(shift, 100.0), -11.503957783641161, 1e-12);
  // About T_g + 50 K the same law has the constants 8.86 and 101.6 K, rounded as printed.
  const Shift above = wlf(8.86, 101.6, 50.0);
  for (const double temperature : {10.0, 40.0, 50.0, 80.0}) {
    EXPECT_NEAR(decades(above, temperature), decades(shift, temperature) - decades(shift, 50.0), 0.02) << temperature;
  }
}

// J. D. Ferry, Viscoelastic Properties of Polymers, 3rd ed. 1980, table 11-II, states 8.61 and 200.4 K at 298 K for
// polyisobutylene. By hand, 8.61 25/(200.4 -+ 25) = 215.25/175.4 and 215.25/225.4.
TEST(WlfShift, PolyisobutyleneOfFerry) {
  const double reference = 298.0 - 273.15;
  const Shift shift = wlf(8.61, 200.4, reference);
  EXPECT_NEAR(decades(shift, reference - 25.0), 1.227194982896237, 1e-12);
  EXPECT_NEAR(decades(shift, reference + 25.0), -0.954968944099379, 1e-12);
}

// For natural rubber (Hevea) the same table states 8.86 and 101.6 K at 248 K. At 20 degC the constants are C_2 = 101.6
// + 45.15 and C_1 = 8.86 101.6/C_2.
TEST(WlfShift, ConstantsAtAnotherReferenceAreTheSameLaw) {
  const Shift natural = wlf(8.86, 101.6, 248.0 - 273.15);
  const double c2 = 101.6 + 45.15;
  const Shift at_20 = wlf(8.86 * 101.6 / c2, c2, 20.0);
  for (const double temperature : {-40.0, 0.0, 20.0, 60.0}) {
    EXPECT_NEAR(decades(at_20, temperature), decades(natural, temperature) - decades(natural, 20.0), 1e-12);
  }
}

TEST(WlfShift, HoldsAsFarAsTwentyDecadesToTheSlowSide) {
  const Shift shift = wlf(17.44, 51.6, 0.0);
  const element::Range range = shift->temperatures();
  EXPECT_NEAR(decades(shift, range.lower), element::kMostDecades, 1e-9);
  EXPECT_FALSE(range.contains(-51.6));
  EXPECT_TRUE(range.contains(200.0));
}

// The value is exp(50000/8.31446 (1/303.15 - 1/293.15)), computed separately.
TEST(ArrheniusShift, FactorOfAnActivationEnergy) {
  const Shift shift = arrhenius(50e3, 20.0);
  EXPECT_DOUBLE_EQ(shift->at(20.0).time, 1.0);
  EXPECT_NEAR(shift->at(30.0).time, 0.5083, 5e-5);
  EXPECT_NEAR(std::log(shift->at(30.0).time), 50e3 / 8.31446261815324 * (1.0 / 303.15 - 1.0 / 293.15), 1e-12);
}

// E = ln(10) R T_0^2 C_1/C_2 gives the slope of WLF at its reference. Over 1 K, the two laws differ by at most 1 % of
// the shift.
TEST(ArrheniusShift, HasTheSlopeOfWlf) {
  const Shift of_wlf = wlf(8.61, 200.4, 25.0);
  const double energy = std::log(10.0) * 8.31446261815324 * 298.15 * 298.15 * 8.61 / 200.4;
  const Shift shift = arrhenius(energy, 25.0);
  EXPECT_NEAR(decades(shift, 26.0), decades(of_wlf, 26.0), 0.01 * std::abs(decades(of_wlf, 26.0)));
}

TEST(ArrheniusShift, HoldsAsFarAsTwentyDecadesToTheSlowSide) {
  const Shift shift = arrhenius(300e3, 20.0);
  EXPECT_NEAR(decades(shift, shift->temperatures().lower), element::kMostDecades, 1e-9);
  EXPECT_TRUE(shift->temperatures().contains(500.0));
  const Shift back = arrhenius(-1e6, 20.0);
  EXPECT_NEAR(decades(back, back->temperatures().upper), element::kMostDecades, 1e-9);
}

// In entropic elasticity the force factor is T/T_0, linear in T with the coefficient 1/T_0, 1/(293.15 K) at 20 degC.
TEST(VerticalShift, ProportionalToTheAbsoluteTemperature) {
  const Shift vertical = shiftOf(entry("vertical_shift", {{"coefficient", 1.0 / 293.15}, {"reference", 20.0}}));
  EXPECT_NEAR(vertical->at(80.0).force, 353.15 / 293.15, 1e-15);
  EXPECT_NEAR(vertical->at(-40.0).force, 233.15 / 293.15, 1e-15);
  EXPECT_NEAR(vertical->temperatures().lower, -273.15, 1e-9);
}

TEST(TransitionShift, RisesTowardsTheCold) {
  const Shift shift = shiftOf(entry("transition_shift", {{"share", 0.2}, {"width", 10.0}, {"reference", 20.0}}));
  EXPECT_EQ(shift->at(20.0).force, 1.0);
  EXPECT_EQ(shift->at(-30.0).time, 1.0);
  EXPECT_DOUBLE_EQ(shift->at(10.0).force, 1.0 + 0.2 * (std::exp(1.0) - 1.0));
  EXPECT_NEAR(shift->at(300.0).force, 0.8, 1e-12);
}

TEST(TransitionShift, HoldsWhereTheFactorIsPositive) {
  const Shift shift = shiftOf(entry("transition_shift", {{"share", 2.0}, {"width", 10.0}, {"reference", 20.0}}));
  const double end = 20.0 + 10.0 * std::log(2.0);
  EXPECT_NEAR(shift->temperatures().upper, end, 1e-12);
  EXPECT_NEAR(shift->at(end).force, 0.0, 1e-12);
  EXPECT_FALSE(shift->temperatures().contains(end));
}

TEST(VerticalShift, HoldsWhereTheFactorIsPositive) {
  const Shift falling = shiftOf(entry("vertical_shift", {{"coefficient", -0.01}, {"reference", 20.0}}));
  EXPECT_TRUE(falling->temperatures().contains(119.0));
  EXPECT_FALSE(falling->temperatures().contains(120.0));
  EXPECT_FALSE(falling->temperatures().contains(-274.0));
  const Shift rising = shiftOf(entry("vertical_shift", {{"coefficient", 0.01}, {"reference", 20.0}}));
  EXPECT_FALSE(rising->temperatures().contains(-80.0));
  EXPECT_TRUE(rising->temperatures().contains(-79.0));
}

}  // namespace
}  // namespace rubber_suspension
