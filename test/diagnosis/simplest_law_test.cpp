// The law with the fewest parameters, and the component file to which it is written.
#include "diagnosis/results/simplest_law.h"

#include "diagnosis/effect.h"
#include "diagnosis/hypotheses/fitted_component.h"
#include "diagnosis/judge/numbers.h"
#include "diagnosis/report/augmented_yaml.h"
#include "diagnosis/results/written_law.h"
#include "fit/fitter.h"
#include "gap/simulate.h"
#include "rig.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

using diagnosis::headlineOf;

std::size_t numbersIn(const diagnosis::results::Entries& entries) {
  return diagnosis::results::numbersOf(entries).size();
}

TEST(NumbersOfALaw, AreThoseThatAFitMoves) {
  EXPECT_EQ(numbersIn({{"friction", {{"maximum_force", {100.0}}, {"displacement", {1e-4}}, {"dead_band", {0.0}}}}}),
            2U);
  EXPECT_EQ(numbersIn({{"bump_stop", {{"stiffness", {1e6}}, {"gap", {2e-3}}, {"side", {1.0}}, {"exponent", {1.0}}}}}),
            2U)
      << "an exponent at the end of its range says that the stop is linear";
  EXPECT_EQ(numbersIn({{"iwan_table", {{"yield_displacement", {1e-4, 2e-4, 4e-4}}, {"stiffness", {1e6, 1e6, 1e6}}}}}),
            6U);
}

// Fits the full law of a candidate to logs of a component that lacks a law.
class SimplestLaw : public testing::Test {
 protected:
  void fit(const std::string& effect, const diagnosis::results::Entries& missing) {
    std::vector<gap::PreparedRecord> records;
    for (const int seed : {1, 2}) {
      records.push_back(log::makeRecord(runRig("log", seed, nothing)));
    }
    const gap::Forces added = gap::simulate(missing, records);
    for (std::size_t r = 0; r < records.size(); ++r) {
      records[r].force += added[r];
    }
    fitter_ = std::make_unique<fit::Fitter>(records, model_, kOneDeviation);
    candidates_ = diagnosis::candidates(fit::summarise(records));
    int member = 0;
    while (candidates_[static_cast<std::size_t>(member)].effect != effect) {
      ++member;
    }
    fit::findUnitEffects(candidates_, records, 1);
    full_.hypothesis = fit::makeHypothesis(candidates_, {member});
    full_.fit = fitter_->fit(full_.hypothesis, fitter_->configured(full_.hypothesis), {10});
    simple_ = diagnosis::results::simplestLaw(*fitter_, candidates_, full_, {}, 1.0, 1);
  }

  diagnosis::results::Entries found() const {
    return simple_.fitted.law.at(simple_.fitted.fit.parameters.scales).at(0);
  }

  void expectPaid() const {
    const double allowed = std::pow(full_.fit.held_out, 2) + std::pow(simple_.form_error.at(0), 2) +
                           std::pow(diagnosis::judge::fittedNumbers().accepted, 2);
    EXPECT_LE(std::pow(simple_.fitted.fit.held_out, 2), allowed);
    EXPECT_LT(numbersIn(found()), numbersIn(diagnosis::hypotheses::entriesOf(full_)));
  }

  const fit::ModelParameters model_{rigComponent(), fit::Level::specification};
  std::unique_ptr<fit::Fitter> fitter_;
  std::vector<fit::Candidate> candidates_;
  diagnosis::hypotheses::FittedHypothesis full_;
  diagnosis::results::SimplestLaw simple_;
};

// On a settled loop, Iwan's law has 1.99 to 2.37 times the force of Berg's law with the same parameters
// (element/iwan.h). So its fitted maximum force lies between 672 and 800 N if that of Berg's law is 800 N.
TEST_F(SimplestLaw, OfFrictionHasTwoNumbers) {
  fit("friction", {friction(800.0, 1e-4)});
  expectPaid();
  ASSERT_EQ(found().size(), 1U);
  EXPECT_EQ(numbersIn(found()), 2U);
  EXPECT_NEAR(headlineOf(found()).at("maximum_force"), 736.0, 64.0);
}

TEST_F(SimplestLaw, OfASymmetricStopIsOneEntry) {
  fit("bump_stop", {{"bump_stop", {{"stiffness", {2e6}}, {"gap", {1.3e-3}}}}});
  expectPaid();
  ASSERT_EQ(found().size(), 1U);
  EXPECT_NEAR(found()[0].value("gap"), 1.3e-3, 2e-5);
  EXPECT_NEAR(found()[0].value("stiffness"), 2e6, 4e4);
}

// A law with fewer parameters is no evidence about how hard the stop is.
TEST_F(SimplestLaw, OfAStopWeighsOtherLawsByTheirErrorsAlone) {
  fit("bump_stop", {{"bump_stop", {{"stiffness", {2e6}}, {"gap", {1.32e-3}}, {"exponent", {1.3}}}}});
  ASSERT_FALSE(simple_.others.empty());
  for (const diagnosis::results::WeighedLaw& other : simple_.others) {
    const bool is_better = other.fitted.fit.held_out < simple_.fitted.fit.held_out;
    EXPECT_EQ(other.odds > 1.0, is_better) << other.odds;
    EXPECT_GT(other.odds, 0.0);
  }
}

// Berg's friction needs a dead band against sensor noise. Iwan's sliders do not.
TEST_F(SimplestLaw, OfFrictionMayBeIwans) {
  fit("friction", {{"iwan", {{"maximum_force", {800.0}}, {"displacement", {1e-4}}}}});
  expectPaid();
  ASSERT_EQ(found().size(), 1U);
  EXPECT_EQ(numbersIn(found()), 2U);
  EXPECT_NEAR(headlineOf(found()).at("maximum_force"), 800.0, 80.0);
}

// The candidate has fluid tracks on both sides of the resonance at 4.1 Hz and of the damping ratio of 0.2.
TEST_F(SimplestLaw, OfAHydraulicMountIsOneTrack) {
  fit("fluid_inertia", {{"inertia_track", {{"mass", {600.0}}, {"damping", {6200.0}}, {"stiffness", {4e5}}}}});
  expectPaid();
  ASSERT_EQ(found().size(), 1U);
  EXPECT_EQ(numbersIn(found()), 3U);
  EXPECT_NEAR(found()[0].value("mass"), 600.0, 12.0);
  EXPECT_NEAR(found()[0].value("stiffness"), 4e5, 8e3);
}

// Loss grows with the square of the rate. Two linear tracks would imitate this with six parameters instead of four.
TEST_F(SimplestLaw, OfATurbulentMountIsOneTrack) {
  fit("fluid_inertia",
      {{"inertia_track",
        {{"mass", {600.0}}, {"damping", {1500.0}}, {"stiffness", {4e5}}, {"quadratic_damping", {1.5e5}}}}});
  expectPaid();
  ASSERT_EQ(found().size(), 1U);
  EXPECT_EQ(numbersIn(found()), 4U);
  EXPECT_NEAR(found()[0].value("mass"), 600.0, 12.0);
  EXPECT_NEAR(found()[0].value("stiffness"), 4e5, 8e3);
  EXPECT_NEAR(found()[0].value("quadratic_damping"), 1.5e5, 1.5e4);
}

diagnosis::SizedValue written(const std::string& place, const std::string& unit, double configured, double value,
                              std::array<double, 2> interval) {
  return {"", place, unit, configured, value, interval};
}

io::ComponentDescription inUnits() {
  return componentOf(
      "components:\n  bush:\n    model: maxwell\n    specification:\n      static_stiffness: 0.9 kN/mm\n"
      "      dynamic_stiffness: 1.3 kN/mm\n      nominal_frequency: 4\n      break_frequency: 3\n");
}

TEST(WrittenComponent, HasNumbersThatAreKnown) {
  diagnosis::Diagnosis d;
  d.component = "bush";
  io::ComponentDescription exact = inUnits();
  exact.add = {friction(216.18, 1.2345678e-4)};
  auto specification = exact.specification();
  specification.set("static_stiffness", 896345.6789);
  exact.specify(specification);
  d.law.numbers = {written("specification.static_stiffness", "N/m", 0.9e6, 896345.6789, {886e3, 906e3}),
                   written("specification.nominal_frequency", "Hz", 4.0, 4.0, {4.0, 4.0}),
                   written("add[0].maximum_force", "N", std::nan(""), 216.18, {195.0, 240.0})};
  d.law.numbers = diagnosis::results::rounded(d.law.numbers, exact, 0);
  d.law.augmented = diagnosis::results::asWritten(exact, d.law.numbers);
  EXPECT_DOUBLE_EQ(d.law.augmented.specification().at("static_stiffness"), 896e3) << "half the interval is 10 N/mm";
  EXPECT_DOUBLE_EQ(d.law.augmented.add[0].value("maximum_force"), 216.0);
  EXPECT_DOUBLE_EQ(d.law.augmented.add[0].value("displacement"), 1.2345678e-4) << "nothing is known of its interval";
  const std::string text = diagnosis::report::augmentedYaml(d);
  EXPECT_THAT(text, HasSubstr("static_stiffness: 0.896 kN/mm  # 95 %: 0.886 to 0.906 kN/mm; was 0.9 kN/mm"));
  EXPECT_THAT(text, HasSubstr("# maximum_force: 95 %: 195 to 240 N"));
  const auto read = componentOf(text);
  EXPECT_EQ(io::toYaml({read}), io::toYaml({d.law.augmented})) << "the file is the component, to the last bit";
}

// Large numbers are rounded as well, and the limits of an interval have as many digits as their value.
TEST(WrittenComponent, HasIntervalsInTheDigitsOfTheNumbers) {
  diagnosis::Diagnosis d;
  io::ComponentDescription exact = inUnits();
  exact.add = {{"progressive_stiffness", {{"cubic", {2.0e11}}, {"quintic", {3.2509785e15}}}}};
  d.law.numbers = {written("specification.dynamic_stiffness", "N/m", 1.3e6, 1.2939e6, {1.2931e6, 1.3003e6}),
                   written("add[0].quintic", "N/m^5", std::nan(""), 3.2509785e15, {2.88e15, 3.6213e15})};
  d.law.numbers = diagnosis::results::rounded(d.law.numbers, exact, 0);
  d.law.augmented = diagnosis::results::asWritten(exact, d.law.numbers);
  const std::string text = diagnosis::report::augmentedYaml(d);
  EXPECT_THAT(text, HasSubstr("quintic: 3.25e+15}"));
  EXPECT_THAT(text, HasSubstr("# quintic: 95 %: 2.88e+15 to 3.62e+15 N/m^5"));
  EXPECT_THAT(text, HasSubstr("# 95 %: 1.2931 to 1.3003 kN/mm; was 1.3 kN/mm"));
}

TEST(Headline, TellsFrictionOverAllTerms) {
  const auto iwan = headlineOf({{"iwan", {{"maximum_force", {300.0}}, {"displacement", {1e-4}}}}});
  EXPECT_NEAR(iwan.at("maximum_force"), 300.0, 1e-9);
  EXPECT_NEAR(iwan.at("displacement"), 1e-4, 1e-12);
  const auto both =
      headlineOf({friction(200.0, 1e-4), {"iwan_table", {{"yield_displacement", {1e-4}}, {"stiffness", {2e6}}}}});
  EXPECT_NEAR(both.at("maximum_force"), 400.0, 1e-9);
  EXPECT_NEAR(both.at("displacement"), (std::sqrt(5.0) - 1.0) / 2.0 * 1e-4, 1e-9) << "z: 200 z/(z + 1) + 200 z = 200";
}

TEST(Headline, TellsStopsBySide) {
  const auto values = headlineOf({{"bump_stop", {{"stiffness", {1e6}}, {"gap", {2e-3}}, {"side", {1.0}}}},
                                  {"bump_stop", {{"stiffness", {2e6}}, {"gap", {3e-3}}, {"side", {1.0}}}},
                                  {"bump_stop", {{"stiffness", {4e6}}, {"gap", {1e-3}}, {"side", {-1.0}}}}});
  EXPECT_DOUBLE_EQ(values.at("gap_in_tension"), 2e-3);
  EXPECT_DOUBLE_EQ(values.at("stiffness_in_tension"), 3e6);
  EXPECT_DOUBLE_EQ(values.at("gap_in_compression"), 1e-3);
  EXPECT_DOUBLE_EQ(values.at("stiffness_in_compression"), 4e6);
}

// The width of a dead zone does not measure the lost motion if only a tenth of the motion passes through the zone.
TEST(Headline, TellsPlayByTheMotionThatIsLost) {
  EXPECT_DOUBLE_EQ(headlineOf({{"free_play", {{"gap", {1e-4}}}}}).at("gap"), 1e-4);
  const auto both = headlineOf(
      {{"free_play", {{"gap", {1e-4}}, {"share", {0.9}}}}, {"free_play", {{"gap", {2e-3}}, {"share", {0.01}}}}});
  EXPECT_DOUBLE_EQ(both.at("total_gap"), 0.9 * 1e-4 + 0.01 * 2e-3);
}

TEST(Headline, TellsTemperaturePerKelvinAtTheReference) {
  const auto values = headlineOf({{"vertical_shift", {{"coefficient", {-2e-3}}, {"reference", {20.0}}}},
                                  {"transition_shift", {{"share", {0.1}}, {"width", {50.0}}, {"reference", {20.0}}}},
                                  {"arrhenius_shift", {{"activation_energy", {7e4}}, {"reference", {20.0}}}}});
  EXPECT_DOUBLE_EQ(values.at("change_of_stiffness_at_20_degC"), -2e-3 - 0.1 / 50.0);
  EXPECT_NEAR(values.at("change_of_rates_at_20_degC"), 7e4 / (8.31446261815324 * 293.15 * 293.15), 1e-12);
}

}  // namespace
}  // namespace rubber_suspension
