// Model parameters, records, noise, and the candidates.
#include "diagnosis/effect.h"
#include "diagnosis/judge/score.h"
#include "fit/excitation.h"
#include "fit/fitter.h"
#include "fit/model_parameters.h"
#include "gap/simulate.h"
#include "io/effect_names.h"
#include "measurement/friction_noise.h"
#include "rig.h"
#include "rubber_suspension/log/record.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

io::ComponentDescription fiveInputs() {
  return componentOf(
      "components:\n  bush:\n    model: multi_maxwell\n    specification:\n      static_stiffness: 3.0e6\n"
      "      dynamic_stiffness: 4.2e6\n      nominal_frequency: 4.0\n      maximum_stiffness: 4.9e6\n"
      "      high_frequency: 25.0\n");
}

TEST(ModelParameters, LeaveTheConfiguredModelAsItIs) {
  for (const fit::Level level : {fit::Level::specification, fit::Level::elements}) {
    const fit::ModelParameters model(fiveInputs(), level);
    const auto elements = model.elements(Eigen::VectorXd::Zero(model.size()));
    ASSERT_TRUE(elements);
    const auto configured = fiveInputs().allElements();
    ASSERT_EQ(elements->size(), configured.size());
    for (std::size_t i = 0; i < configured.size(); ++i) {
      EXPECT_EQ((*elements)[i].values, configured[i].values);
    }
  }
}

// Any combination of the parameters of the fit is a valid model. The loop draws each parameter up to a factor of 3 off,
// and the ratio of neighbouring stiffnesses (alpha) anywhere within its bounds.
TEST(ModelParameters, HaveAModelEverywhere) {
  const fit::ModelParameters model(fiveInputs(), fit::Level::specification);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const Eigen::VectorXd point = Eigen::VectorXd::NullaryExpr(model.size(), [&](Eigen::Index j) {
      const bool alpha = model.names()[static_cast<std::size_t>(j)] == "alpha";
      return (alpha ? model.bounds()[j] : std::log(3.0)) * uniform(generator);
    });
    const auto elements = model.elements(point);
    ASSERT_TRUE(elements) << point.transpose();
    EXPECT_NEAR((*elements)[0].value("stiffness"), 3.0e6 * std::exp(point[0]), 1e-3);
  }
}

TEST(Record, EstimatesTheNoiseOfTheDisplacement) {
  log::Log log = runRig("log", 1, nothing);
  std::mt19937 generator(5);
  std::normal_distribution<double> noise(0.0, 1e-6);
  for (double& z : log.displacement) {
    z += noise(generator);
  }
  const log::Record record = log::makeRecord(log);
  EXPECT_NEAR(record.displacement_noise, 1e-6, 0.15e-6);  // the median of about 200 averaged spectral lines
  EXPECT_LT(record.highest_frequency, 15.0);              // the estimate uses about 200 averaged spectral lines
}

TEST(Record, FiltersOnlyTheNoiseOutOfTheDisplacement) {
  const log::Log clean = runRig("log", 1, nothing);
  log::Log noisy = clean;
  std::mt19937 generator(5);
  std::normal_distribution<double> noise(0.0, 1e-6);
  for (double& z : noisy.displacement) {
    z += noise(generator);
  }
  const log::Record record = log::makeRecord(noisy);
  ASSERT_GT(record.passed_frequency, 0.0);
  const Eigen::Map<const Eigen::VectorXd> z(clean.displacement.data(), record.size());
  constexpr Eigen::Index kEnds = 250;  // the filter mirrors the displacement at the ends of the log
  const Eigen::Index inner = record.size() - 2 * kEnds;
  const Eigen::VectorXd error = (record.displacement - z).segment(kEnds, inner);
  const double left = std::sqrt(error.squaredNorm() / static_cast<double>(inner));
  // Noise below the cutoff of the filter remains: the share of its power up to 1.3 times the passed frequency.
  const double expected = 1e-6 * std::sqrt(1.3 * record.passed_frequency * 2.0 * record.dt);
  EXPECT_LT(left, 1.3 * expected);
  EXPECT_LT(left, 0.7e-6);
}

log::Log noisyLog(double noise) {
  log::Log log = runRig("log", 1, nothing);
  std::mt19937 generator(5);
  std::normal_distribution<double> normal(0.0, noise);
  for (double& z : log.displacement) {
    z += normal(generator);
  }
  return log;
}

double rootMeanSquare(const Eigen::VectorXd& values) {
  return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

TEST(FrictionNoise, IsNothingWithoutFriction) {
  EXPECT_EQ(measurement::frictionNoise(rigComponent().allElements(), {log::makeRecord(noisyLog(5e-6))}),
            std::vector<double>{0.0});
}

// The displacement without noise is known here, so the effect of the noise on Berg's friction can be computed.
TEST(FrictionNoise, IsOfTheOrderOfWhatNoiseDoes) {
  const std::vector<element::ElementDescription> friction = {
      {"friction", {{"maximum_force", {300.0}}, {"displacement", {2e-4}}, {"dead_band", {2e-5}}}}};
  log::Record clean = log::makeRecord(noisyLog(0.0));
  const log::Record noisy = log::makeRecord(noisyLog(5e-6));
  clean.force_deviation = noisy.force_deviation;
  const Eigen::VectorXd done =
      gap::simulate(friction, {noisy}, gap::asRecorded)[0] - gap::simulate(friction, {clean})[0];
  const double known = rootMeanSquare(done) / noisy.force_deviation;
  const double estimated = measurement::frictionNoise(friction, {noisy}).front();
  EXPECT_GT(known, 1e-3) << "there is something to be estimated";
  // The test compares one draw of a few events with a mean over three draws and three dead bands.
  EXPECT_GT(estimated, 0.4 * known);
  EXPECT_LT(estimated, 2.5 * known);
}

TEST(MassBandwidth, FiltersOnlyWhereThereIsNoise) {
  EXPECT_EQ(fit::massBandwidth({log::makeRecord(noisyLog(0.0))}, 7.0), 0.0);
  const double bandwidth = fit::massBandwidth({log::makeRecord(noisyLog(3e-6))}, 7.0);
  EXPECT_GT(bandwidth, 7.0);
  EXPECT_LT(bandwidth, fit::massBandwidth({log::makeRecord(noisyLog(3e-7))}, 7.0))
      << "less noise asks for less of a filter";
}

TEST(Record, ResamplesAnUnevenTimeBaseAndSaysSo) {
  log::Log log = runRig("log", 1, nothing);
  for (std::size_t i = 0; i < log.size(); i += 2) {
    log.stamp[i] += 1000000;
  }
  const log::Record record = log::makeRecord(log);
  ASSERT_FALSE(record.notes.empty());
  EXPECT_NE(record.notes.front().find("uneven"), std::string::npos);
}

TEST(Record, RefusesALogThatDoesNotMove) {
  log::Log log = runRig("log", 1, nothing);
  std::fill(log.displacement.begin(), log.displacement.end(), 0.001);
  EXPECT_THROW(log::makeRecord(log), log::LogError);
}

// Scales of the basis terms of each candidate, in units of their typical scales. Terms not listed have scale zero.
using Scales = std::map<std::string, std::vector<double>>;

// Returns the hypothesis of the listed candidates, each with as many basis terms as it has scales.
fit::Hypothesis hypothesisOf(std::vector<fit::Candidate> candidates, const Scales& scales) {
  std::vector<int> members;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const auto at_work = scales.find(candidates[c].effect);
    if (at_work != scales.end()) {
      candidates[c].terms.resize(at_work->second.size());
      members.push_back(static_cast<int>(c));
    }
  }
  fit::Hypothesis hypothesis = fit::makeHypothesis(candidates, members);
  hypothesis.free_in_log.trend = true;
  return hypothesis;
}

Eigen::VectorXd scalesOf(const std::vector<fit::Candidate>& candidates, const Scales& scales) {
  std::vector<double> numbers;
  for (const fit::Candidate& candidate : candidates) {
    const auto at_work = scales.find(candidate.effect);
    for (std::size_t t = 0; at_work != scales.end() && t < at_work->second.size(); ++t) {
      numbers.push_back(at_work->second[t] * candidate.terms[t].typical);
    }
  }
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

TEST(Candidates, AreEnteredOnceEach) {
  const std::vector<gap::PreparedRecord> records = {log::makeRecord(noisyLog(0.0))};
  std::set<std::string> names;
  for (const fit::Candidate& candidate : diagnosis::candidates(fit::summarise(records))) {
    EXPECT_TRUE(names.insert(candidate.effect).second) << candidate.effect;
    // The logs contain no temperature, no displacement across, and forces of both signs.
    EXPECT_EQ(candidate.applies(), candidate.effect != "temperature" && candidate.effect != "radial_coupling" &&
                                       candidate.effect != "lift_off")
        << candidate.effect;
    EXPECT_FALSE(candidate.documentation.empty()) << candidate.effect;
  }
  // These are all effects that reports may name, besides parameter_error and unknown.
  const std::set<std::string> contract = {
      "friction",        "relaxation", "creep",        "viscous_damping",   "progressive_stiffness",
      "free_play",       "bump_stop",  "self_heating", "stress_softening",  "asymmetric_stiffness",
      "inertia",         "time_delay", "force_offset", "series_compliance", "rate_amplitude_coupling",
      "force_drift",     "backlash",   "temperature",  "sensor_gain",       "fluid_inertia",
      "radial_coupling", "lift_off",   "payne_effect"};
  EXPECT_EQ(names, contract);
  EXPECT_THAT(io::effectNames(), ::testing::ElementsAreArray(names)) << "that a component file may exclude";
}

// Radial coupling needs a displacement across that is neither negligible nor proportional to the displacement.
TEST(Candidates, RadialCouplingNeedsAnotherDisplacement) {
  const auto offered = [](double share, double apart) {
    log::Log log = noisyLog(0.0);
    for (std::size_t i = 0; i < log.size(); ++i) {
      log.across.push_back(share * log.displacement[i] + apart * 1e-3 * std::sin(11.0 * log.time(i)));
    }
    for (const fit::Candidate& candidate : diagnosis::candidates(fit::summarise({log::makeRecord(log)}))) {
      if (candidate.effect == "radial_coupling") {
        return candidate.applies();
      }
    }
    return false;
  };
  EXPECT_TRUE(offered(0.0, 1.0));
  EXPECT_TRUE(offered(1.0, 1.0));
  EXPECT_FALSE(offered(1.0, 0.0));
  EXPECT_FALSE(offered(0.0, 0.01));
}

// Lift-off is offered if the forces of one sign are weak. Below the size of a sensor offset, its only term is a contact
// without preload. Above, it also has contacts with a preload and a slack stiffness.
TEST(Candidates, LiftOffNeedsForcesOfOneSign) {
  for (const double side : {1.0, -1.0}) {
    for (const double share : {0.0, 0.05, 0.25, 0.5, 0.9}) {
      log::Log log = noisyLog(0.0);
      for (double& force : log.force) {
        force *= side * force > 0.0 ? 1.0 : share;
      }
      const auto all = diagnosis::candidates(fit::summarise({log::makeRecord(log)}));
      const auto found = std::find_if(all.begin(), all.end(), [](const auto& c) { return c.effect == "lift_off"; });
      ASSERT_NE(found, all.end());
      const fit::Hypothesis alone = fit::makeHypothesis(all, {static_cast<int>(found - all.begin())});
      EXPECT_EQ(found->terms.size(), share > 0.7 ? 0U : share > 0.1 ? 4U : 1U) << side << " " << share;
      EXPECT_EQ(alone.held.size(), found->applies() ? 1U : 0U) << side << " " << share;
      for (const fit::BasisTerm& term : found->terms) {
        EXPECT_EQ(term.at(1.0).value("side"), side);
        EXPECT_EQ(term.at(1.0).values.count("preload"), &term == &found->terms.front() ? 0U : 1U);
      }
    }
  }
}

// A candidate that contains others has their basis terms once each. It counts as more mechanisms than they do.
TEST(Candidates, HoldTheTermsOfWhatTheyContain) {
  std::vector<fit::Candidate> all = diagnosis::candidates(fit::summarise({log::makeRecord(noisyLog(0.0))}));
  const auto placeOf = [&](const std::string& effect) {
    return static_cast<int>(std::find_if(all.begin(), all.end(), [&](const auto& c) { return c.effect == effect; }) -
                            all.begin());
  };
  const auto termsOf = [&](int candidate) { return all[static_cast<std::size_t>(candidate)].terms.size(); };
  const int friction = placeOf("friction");
  const int relaxation = placeOf("relaxation");
  const int stop = placeOf("bump_stop");
  const int backlash = placeOf("backlash");
  const int coupling = placeOf("rate_amplitude_coupling");
  std::set<std::pair<std::string, std::string>> contained;
  for (const fit::Candidate& larger : all) {
    for (const fit::Candidate& smaller : all) {
      if (fit::contains(larger, smaller)) {
        contained.emplace(larger.effect, smaller.effect);
      }
    }
  }
  EXPECT_EQ(contained, (std::set<std::pair<std::string, std::string>>{{"backlash", "friction"},
                                                                      {"fluid_inertia", "inertia"},
                                                                      {"payne_effect", "relaxation"},
                                                                      {"rate_amplitude_coupling", "friction"},
                                                                      {"rate_amplitude_coupling", "relaxation"}}));
  const fit::Hypothesis both = fit::makeHypothesis(all, {backlash, coupling});
  EXPECT_EQ(both.counts,
            (std::vector<std::size_t>{termsOf(backlash) + termsOf(friction), termsOf(coupling) + termsOf(relaxation)}));
  EXPECT_EQ(fit::makeHypothesis(all, {coupling}, {relaxation}).held, std::vector<int>{relaxation});
  EXPECT_EQ(fit::makeHypothesis(all, {coupling}).held, std::vector<int>{friction});
  const auto mechanisms = [&](int candidate) {
    return diagnosis::judge::mechanismsOf(all[static_cast<std::size_t>(candidate)].contains.size());
  };
  EXPECT_EQ(mechanisms(friction) + mechanisms(backlash) + mechanisms(coupling), 4U);
  EXPECT_TRUE(fit::holds(all, {backlash, coupling}, {friction, relaxation}));
  EXPECT_FALSE(fit::holds(all, {backlash}, {relaxation}));
  EXPECT_FALSE(fit::holds(all, {coupling}, {friction, relaxation})) << "one at a time";

  const auto beyond = [&](int member, const std::map<int, std::size_t>& at_work) {
    const fit::Hypothesis hypothesis = fit::makeHypothesis(all, {member}, {relaxation});
    Eigen::VectorXd scales = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(hypothesis.terms.size()));
    for (std::size_t t = 0; t < hypothesis.places.size(); ++t) {
      const auto count = at_work.find(hypothesis.places[t].candidate);
      scales[static_cast<Eigen::Index>(t)] = count != at_work.end() && hypothesis.places[t].term < count->second;
    }
    return fit::numbersBeyond(all, hypothesis, scales);
  };
  EXPECT_EQ(beyond(friction, {{friction, 5}}), 0U);
  EXPECT_EQ(beyond(stop, {{stop, 4}}), 0U) << "a gap between two of the knees on each side";
  EXPECT_EQ(beyond(stop, {{stop, 7}}), 3U) << "a curve without a knee";
  EXPECT_EQ(beyond(backlash, {{friction, 5}}), 1U) << "the clearance";
  EXPECT_EQ(beyond(backlash, {{friction, 5}, {backlash, 2}}), 3U);
  all[static_cast<std::size_t>(friction)].numbers_alone = 5;
  EXPECT_EQ(beyond(backlash, {{backlash, 5}}), 1U) << "sliders behind the clearance replace those of friction alone";
  EXPECT_EQ(beyond(backlash, {{friction, 3}, {backlash, 4}}), 3U);
  EXPECT_EQ(beyond(backlash, {{backlash, 2}}), 1U) << "no simpler than friction";
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(both.terms.size()));
  Eigen::VectorXd relaxing = none;
  relaxing.tail(static_cast<Eigen::Index>(termsOf(relaxation))).head(3).setOnes();
  ASSERT_EQ(both.places.back().candidate, relaxation);
  EXPECT_EQ(fit::numbersBeyond(all, both, none), 2U) << "the clearance and the coupling";
  EXPECT_EQ(fit::numbersBeyond(all, both, relaxing), 2U) << "friction belongs to the backlash, not to the coupling";
  relaxing.segment(static_cast<Eigen::Index>(both.counts[0]), 2).setOnes();
  EXPECT_EQ(fit::numbersBeyond(all, both, relaxing), 3U) << "two numbers of the coupling beyond relaxation";
  EXPECT_EQ(beyond(coupling, {{relaxation, 4}}), 1U) << "at its limit it is not free";
  EXPECT_EQ(beyond(coupling, {{relaxation, 4}, {coupling, 2}}), 2U);
}

class KnownEffects : public testing::TestWithParam<std::vector<element::ElementDescription>> {};

INSTANTIATE_TEST_SUITE_P(
    OfAModelWith, KnownEffects,
    testing::Values(std::vector<element::ElementDescription>{},
                    std::vector<element::ElementDescription>{
                        {"self_heating", {{"energy_sensitivity", {0.02}}, {"time_constant", {10.0}}}}},
                    std::vector<element::ElementDescription>{{"inertia", {{"mass", {30.0}}}}},
                    std::vector<element::ElementDescription>{{"time_delay", {{"delay", {0.01}}}}},
                    std::vector<element::ElementDescription>{{"series_compliance", {{"stiffness", {1e7}}}}}));

// Superposing unit effects gives the same forces and normal equations as simulating the whole model.
TEST_P(KnownEffects, AreWhatSimulationGives) {
  io::ComponentDescription component = rigComponent();
  component.add = GetParam();
  std::vector<gap::PreparedRecord> records = {log::makeRecord(runRig("first", 1, nothing)),
                                              log::makeRecord(runRig("second", 2, nothing))};
  const fit::ModelParameters model(component, fit::Level::specification);
  const fit::Fitter fitter(records, model, kOneDeviation);
  const std::vector<fit::Candidate> plain = diagnosis::candidates(fit::summarise(records));
  std::vector<fit::Candidate> known = plain;
  fit::findUnitEffects(known, records, 2);
  const std::vector<Scales> cases = {
      {{"friction", {1.0, 0.0, 0.5}}, {"force_offset", {1.0}}},
      {{"stress_softening", {0.0, 1.0, 0.5}}, {"relaxation", {0.0, 1.0}}, {"force_offset", {1.0}}},
      {{"stress_softening", {1.0}}, {"self_heating", {1.0, 0.0}}, {"friction", {1.0}}},
      {{"stress_softening", {0.0}}, {"time_delay", {1.0}}, {"friction", {1.0}}, {"force_offset", {1.0}}}};
  constexpr double kRounding = std::numeric_limits<float>::epsilon();  // unit effects have single precision
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const fit::Hypothesis simulated = hypothesisOf(plain, cases[i]);
    const fit::Hypothesis superposed = hypothesisOf(known, cases[i]);
    fit::ParameterVector parameters = fitter.configured(simulated);
    parameters.scales = scalesOf(plain, cases[i]);
    const auto expected = *fitter.forces().at(simulated, parameters);
    const auto actual = *fitter.forces().at(superposed, parameters);
    for (std::size_t r = 0; r < records.size(); ++r) {
      EXPECT_LE((actual[r] - expected[r]).cwiseAbs().maxCoeff(), kRounding * records[r].force_deviation)
          << "case " << i;
    }
    const fit::BlockGrams expected_grams = fitter.linearise(simulated, parameters);
    const Eigen::MatrixXd& expected_sum = expected_grams.sum;
    const Eigen::MatrixXd actual_sum = fitter.linearise(superposed, parameters, {}, 2).sum;
    // Rows and columns are scaled by their norms before elimination, which reduces an offset to rounding errors.
    const Eigen::VectorXd size = expected_grams.squares.cwiseSqrt().cwiseMax(1e-300);
    const Eigen::MatrixXd difference =
        size.cwiseInverse().asDiagonal() * (actual_sum - expected_sum) * size.cwiseInverse().asDiagonal();
    // Difference quotients have rounding errors of 1e-16/1e-4. Beside other effects in the model, or beside
    // self-heating, the derivatives with respect to scales have an accurate direction, but not an accurate size.
    const bool displaces = !GetParam().empty() || cases[i].count("self_heating") != 0;
    const Eigen::Index of_model = parameters.model.size();
    for (Eigen::Index j = 0; j < difference.cols(); ++j) {
      for (Eigen::Index k = 0; k < difference.rows(); ++k) {
        const auto about = [&](Eigen::Index column) {
          const Eigen::Index term = column - of_model;
          return displaces && term >= 0 && term < parameters.scales.size();
        };
        if (!about(j) && !about(k)) {
          EXPECT_LE(std::abs(difference(k, j)), 1e-8) << "case " << i;
        }
      }
    }
  }
}

}  // namespace
}  // namespace rubber_suspension
