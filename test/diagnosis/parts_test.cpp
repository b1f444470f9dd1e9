// Model parameters, records, what noise does, and the menu of experiments.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <vector>

#include "rig.h"
#include "diagnosis/candidate/registry.h"
#include "diagnosis/report/experiment.h"
#include "diagnosis/friction_noise.h"
#include "fit/fitter.h"
#include "fit/model_parameters.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension {
namespace {

io::ComponentDescription fiveInputs() {
  return io::parseComponentFile(
             "components:\n  bush:\n    model: multi_maxwell\n    specification:\n      static_stiffness: 3.0e6\n"
             "      dynamic_stiffness: 4.2e6\n      nominal_frequency: 4.0\n      maximum_stiffness: 4.9e6\n"
             "      high_frequency: 25.0\n",
             "five inputs")
      .front();
}

TEST(ModelParameters, LeaveTheConfiguredModelAsItIs) {
  for (const fit::Level level : {fit::Level::specification, fit::Level::elements}) {
    const fit::ModelParameters own(fiveInputs(), level);
    const auto elements = own.elements(Eigen::VectorXd::Zero(own.size()));
    ASSERT_TRUE(elements);
    const auto configured = fiveInputs().allElements();
    ASSERT_EQ(elements->size(), configured.size());
    for (std::size_t i = 0; i < configured.size(); ++i) {
      EXPECT_EQ((*elements)[i].values, configured[i].values);
    }
  }
}

// Every point within the bounds has a model: that is what the coordinates are for.
TEST(ModelParameters, HaveAModelEverywhere) {
  const fit::ModelParameters own(fiveInputs(), fit::Level::specification);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const Eigen::VectorXd point =
        Eigen::VectorXd::NullaryExpr(own.size(), [&](Eigen::Index j) { return own.bound(j) * uniform(generator); });
    const auto elements = own.elements(point);
    ASSERT_TRUE(elements) << point.transpose();
    EXPECT_NEAR((*elements)[0].value("stiffness"), 3.0e6 * std::exp(point[0]), 1e-3);
  }
}

TEST(Record, EstimatesTheNoiseOfTheDisplacement) {
  log::Log log = runRig("log", 1, [](double, double, double) { return 0.0; });
  std::mt19937 generator(5);
  std::normal_distribution<double> noise(0.0, 1e-6);
  for (double& z : log.displacement) {
    z += noise(generator);
  }
  const log::Record record = log::makeRecord(log);
  EXPECT_NEAR(record.displacement_noise, 1e-6, 0.15e-6);  // the median of about 200 averaged spectral lines
  EXPECT_LT(record.highest_frequency, 15.0);              // 6.3 Hz is the fastest sine, the sweep spreads it
}

TEST(Record, FiltersOnlyTheNoiseOutOfTheDisplacement) {
  const log::Log clean = runRig("log", 1, [](double, double, double) { return 0.0; });
  log::Log noisy = clean;
  std::mt19937 generator(5);
  std::normal_distribution<double> noise(0.0, 1e-6);
  for (double& z : noisy.displacement) {
    z += noise(generator);
  }
  const log::Record record = log::makeRecord(noisy);
  ASSERT_GT(record.passed_frequency, 0.0);
  const Eigen::Map<const Eigen::VectorXd> z(clean.displacement.data(), record.size());
  constexpr Eigen::Index kEnds = 250;  // where the filter sees a mirrored displacement
  const Eigen::Index inner = record.size() - 2 * kEnds;
  const Eigen::VectorXd error = (record.displacement - z).segment(kEnds, inner);
  const double left = std::sqrt(error.squaredNorm() / static_cast<double>(inner));
  // Noise below the edge of the filter stays: of its power the part up to 1.3 times the passed frequency.
  const double expected = 1e-6 * std::sqrt(1.3 * record.passed_frequency * 2.0 * record.dt);
  EXPECT_LT(left, 1.3 * expected);
  EXPECT_LT(left, 0.7e-6);
}

log::Log noisyLog(double noise) {
  log::Log log = runRig("log", 1, [](double, double, double) { return 0.0; });
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
  EXPECT_EQ(diagnosis::frictionNoise(rigComponent().allElements(), {log::makeRecord(noisyLog(5e-6))}),
            std::vector<double>{0.0});
}

// What noise does to Berg's friction is known here, as the displacement without noise is.
TEST(FrictionNoise, IsOfTheOrderOfWhatNoiseDoes) {
  const std::vector<element::ElementDescription> friction = {
      {"friction", {{"maximum_force", {300.0}}, {"displacement", {2e-4}}, {"dead_band", {2e-5}}}}};
  log::Record clean = log::makeRecord(noisyLog(0.0));
  const log::Record noisy = log::makeRecord(noisyLog(5e-6));
  clean.force_deviation = noisy.force_deviation;
  const Eigen::VectorXd done =
      fit::simulate(friction, {noisy}, [](const log::Record& r) { return r.raw_displacement; })[0] -
      fit::simulate(friction, {clean})[0];
  const double known = rootMeanSquare(done) / noisy.force_deviation;
  const double estimated = diagnosis::frictionNoise(friction, {noisy}).front();
  EXPECT_GT(known, 1e-3) << "there is something to be estimated";
  // One draw of few events, against three of them and three dead bands.
  EXPECT_GT(estimated, 0.4 * known);
  EXPECT_LT(estimated, 2.5 * known);
}

TEST(MassBandwidth, FiltersOnlyWhereThereIsNoise) {
  EXPECT_EQ(diagnosis::massBandwidth({log::makeRecord(noisyLog(0.0))}, 7.0), 0.0);
  const double bandwidth = diagnosis::massBandwidth({log::makeRecord(noisyLog(3e-6))}, 7.0);
  EXPECT_GT(bandwidth, 7.0);
  EXPECT_LT(bandwidth, diagnosis::massBandwidth({log::makeRecord(noisyLog(3e-7))}, 7.0))
      << "less noise asks for less of a filter";
}

TEST(Record, ResamplesAnUnevenTimeBaseAndSaysSo) {
  log::Log log = runRig("log", 1, [](double, double, double) { return 0.0; });
  for (std::size_t i = 0; i < log.size(); i += 2) {
    log.stamp[i] += 1000000;
  }
  const log::Record record = log::makeRecord(log);
  ASSERT_FALSE(record.notes.empty());
  EXPECT_NE(record.notes.front().find("uneven"), std::string::npos);
}

TEST(Record, RefusesALogThatDoesNotMove) {
  log::Log log = runRig("log", 1, [](double, double, double) { return 0.0; });
  std::fill(log.displacement.begin(), log.displacement.end(), 0.001);
  EXPECT_THROW(log::makeRecord(log), log::LogError);
}

// Scales of atoms of a candidate, all others at nothing.
using Scales = std::map<std::string, std::vector<double>>;

std::vector<fit::BasisTerm> atomsOf(const std::vector<fit::Candidate>& candidates, const Scales& scales) {
  std::vector<fit::BasisTerm> atoms;
  for (const fit::Candidate& candidate : candidates) {
    const auto at_work = scales.find(candidate.effect);
    for (std::size_t a = 0; at_work != scales.end() && a < at_work->second.size(); ++a) {
      atoms.push_back(candidate.atoms[a]);
    }
  }
  return atoms;
}

Eigen::VectorXd inUnitsOfTypical(const std::vector<fit::Candidate>& candidates, const Scales& scales) {
  std::vector<double> numbers;
  for (const fit::Candidate& candidate : candidates) {
    const auto at_work = scales.find(candidate.effect);
    for (std::size_t a = 0; at_work != scales.end() && a < at_work->second.size(); ++a) {
      numbers.push_back(at_work->second[a] * candidate.atoms[a].typical);
    }
  }
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
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

// Forces and normal equations from unit effects are those of simulating the whole model.
TEST_P(KnownEffects, AreWhatSimulationGives) {
  io::ComponentDescription component = rigComponent();
  component.add = GetParam();
  const auto nothing = [](double, double, double) { return 0.0; };
  std::vector<log::Record> records = {log::makeRecord(runRig("first", 1, nothing)),
                                      log::makeRecord(runRig("second", 2, nothing))};
  const fit::ModelParameters own(component, fit::Level::specification);
  const fit::Fitter fitter(records, own);
  const std::vector<fit::Candidate> plain = fit::candidates(fit::summarise(records));
  std::vector<fit::Candidate> known = plain;
  fitter.precompute(known, 2);
  const std::vector<Scales> cases = {
      {{"friction", {1.0, 0.0, 0.5}}, {"force_offset", {1.0}}},
      {{"stress_softening", {0.0, 1.0, 0.5}}, {"relaxation", {0.0, 1.0}}, {"force_offset", {1.0}}},
      {{"stress_softening", {1.0}}, {"self_heating", {1.0, 0.0}}, {"friction", {1.0}}},
      {{"stress_softening", {0.0}}, {"time_delay", {1.0}}, {"friction", {1.0}}, {"force_offset", {1.0}}}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::vector<fit::BasisTerm> simulated = atomsOf(plain, cases[i]);
    const std::vector<fit::BasisTerm> superposed = atomsOf(known, cases[i]);
    fit::Point point = fitter.configured(simulated.size());
    point.scales = inUnitsOfTypical(plain, cases[i]);
    const auto expected = *fitter.forces(point, simulated);
    const auto actual = *fitter.forces(point, superposed);
    for (std::size_t r = 0; r < records.size(); ++r) {
      EXPECT_LE((actual[r] - expected[r]).cwiseAbs().maxCoeff(), 1e-9 * records[r].force_deviation) << "case " << i;
    }
    const Eigen::MatrixXd expected_sum = fitter.linearise(point, simulated, true).sum;
    const Eigen::MatrixXd actual_sum = fitter.linearise(point, superposed, true, {}, 2).sum;
    const Eigen::VectorXd size = expected_sum.diagonal().cwiseSqrt().cwiseMax(1e-300);
    const Eigen::MatrixXd difference =
        size.cwiseInverse().asDiagonal() * (actual_sum - expected_sum) * size.cwiseInverse().asDiagonal();
    // Rounding of difference quotients, 1e-16 of the force over the least of the effects, 1e-4 of it.
    EXPECT_LE(difference.cwiseAbs().maxCoeff(), 1e-8) << "case " << i;
  }
}

TEST(Experiments, TellDampingFromRelaxationWhereTheyDiffer) {
  const std::vector<element::ElementDescription> spring = {{"spring", {{"stiffness", {1e6}}}}};
  auto dashpot = spring;
  dashpot.push_back({"dashpot", {{"damping", {1e4}}}});
  auto stop = spring;
  stop.push_back({"bump_stop", {{"stiffness", {1e6}}, {"gap", {0.0015}}}});
  fit::Excitation excitation;
  excitation.largest_displacement = 0.002;
  excitation.highest_frequency = 10.0;
  excitation.highest_rate = 0.05;
  excitation.dt = 0.002;
  const auto menu = diagnosis::experimentMenu(excitation);
  for (const diagnosis::Experiment& experiment : menu) {
    EXPECT_LE(experiment.displacement.cwiseAbs().maxCoeff(), 0.002 * (1.0 + 1e-9)) << experiment.description;
  }
  const diagnosis::Discrimination fast = diagnosis::mostTelling(menu, spring, dashpot, 1.0);
  const diagnosis::Discrimination wide = diagnosis::mostTelling(menu, spring, stop, 1.0);
  ASSERT_NE(fast.experiment, nullptr);
  ASSERT_NE(wide.experiment, nullptr);
  EXPECT_GE(wide.experiment->displacement.cwiseAbs().maxCoeff(), 0.0015);
  EXPECT_GT(fast.difference, 0.0);
}

}  // namespace
}  // namespace rubber_suspension
