// Own parameters, records, what noise does, and the menu of experiments.
#include <gtest/gtest.h>

#include <random>

#include "rig.h"
#include "rubber_suspension/diagnosis/candidate/catalogue.h"
#include "rubber_suspension/diagnosis/experiment.h"
#include "rubber_suspension/diagnosis/friction_noise.h"
#include "rubber_suspension/diagnosis/hypothesis.h"
#include "rubber_suspension/diagnosis/own_parameters.h"
#include "rubber_suspension/diagnosis/record.h"

namespace rubber_suspension {
namespace {

ComponentDescription fiveInputs() {
  return parseComponentFile(
             "components:\n  bush:\n    model: multi_maxwell\n    specification:\n      static_stiffness: 3.0e6\n"
             "      dynamic_stiffness: 4.2e6\n      nominal_frequency: 4.0\n      maximum_stiffness: 4.9e6\n"
             "      high_frequency: 25.0\n",
             "five inputs")
      .front();
}

TEST(OwnParameters, LeaveTheConfiguredModelAsItIs) {
  for (const Level level : {Level::specification, Level::elements}) {
    const OwnParameters own(fiveInputs(), level);
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
TEST(OwnParameters, HaveAModelEverywhere) {
  const OwnParameters own(fiveInputs(), Level::specification);
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
  Log log = runRig("log", 1, [](double, double, double) { return 0.0; });
  std::mt19937 generator(5);
  std::normal_distribution<double> noise(0.0, 1e-6);
  for (double& z : log.displacement) {
    z += noise(generator);
  }
  const Record record = makeRecord(log);
  EXPECT_NEAR(record.displacement_noise, 1e-6, 0.15e-6);  // the median of about 200 averaged spectral lines
  EXPECT_LT(record.highest_frequency, 15.0);              // 6.3 Hz is the fastest sine, the sweep spreads it
}

TEST(Record, FiltersOnlyTheNoiseOutOfTheDisplacement) {
  const Log clean = runRig("log", 1, [](double, double, double) { return 0.0; });
  Log noisy = clean;
  std::mt19937 generator(5);
  std::normal_distribution<double> noise(0.0, 1e-6);
  for (double& z : noisy.displacement) {
    z += noise(generator);
  }
  const Record record = makeRecord(noisy);
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

Log noisyLog(double noise) {
  Log log = runRig("log", 1, [](double, double, double) { return 0.0; });
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
  EXPECT_EQ(frictionNoise(rigComponent().allElements(), {makeRecord(noisyLog(5e-6))}), std::vector<double>{0.0});
}

// What noise does to Berg's friction is known here, as the displacement without noise is.
TEST(FrictionNoise, IsOfTheOrderOfWhatNoiseDoes) {
  const std::vector<ElementDescription> friction = {
      {"friction", {{"maximum_force", {300.0}}, {"displacement", {2e-4}}, {"dead_band", {2e-5}}}}};
  Record clean = makeRecord(noisyLog(0.0));
  const Record noisy = makeRecord(noisyLog(5e-6));
  clean.force_deviation = noisy.force_deviation;
  const Eigen::VectorXd done = simulate(friction, {noisy}, [](const Record& r) { return r.raw_displacement; })[0] -
                               simulate(friction, {clean})[0];
  const double known = rootMeanSquare(done) / noisy.force_deviation;
  const double estimated = frictionNoise(friction, {noisy}).front();
  EXPECT_GT(known, 1e-3) << "there is something to be estimated";
  // One draw of few events, against three of them and three dead bands.
  EXPECT_GT(estimated, 0.4 * known);
  EXPECT_LT(estimated, 2.5 * known);
}

TEST(MassBandwidth, FiltersOnlyWhereThereIsNoise) {
  EXPECT_EQ(massBandwidth({makeRecord(noisyLog(0.0))}, 7.0), 0.0);
  const double bandwidth = massBandwidth({makeRecord(noisyLog(3e-6))}, 7.0);
  EXPECT_GT(bandwidth, 7.0);
  EXPECT_LT(bandwidth, massBandwidth({makeRecord(noisyLog(3e-7))}, 7.0)) << "less noise asks for less of a filter";
}

TEST(Record, ResamplesAnUnevenTimeBaseAndSaysSo) {
  Log log = runRig("log", 1, [](double, double, double) { return 0.0; });
  for (std::size_t i = 0; i < log.size(); i += 2) {
    log.stamp[i] += 1000000;
  }
  const Record record = makeRecord(log);
  ASSERT_FALSE(record.notes.empty());
  EXPECT_NE(record.notes.front().find("uneven"), std::string::npos);
}

TEST(Record, RefusesALogThatDoesNotMove) {
  Log log = runRig("log", 1, [](double, double, double) { return 0.0; });
  std::fill(log.displacement.begin(), log.displacement.end(), 0.001);
  EXPECT_THROW(makeRecord(log), LogError);
}

TEST(Experiments, TellDampingFromRelaxationWhereTheyDiffer) {
  const std::vector<ElementDescription> spring = {{"spring", {{"stiffness", {1e6}}}}};
  auto dashpot = spring;
  dashpot.push_back({"dashpot", {{"damping", {1e4}}}});
  auto stop = spring;
  stop.push_back({"bump_stop", {{"stiffness", {1e6}}, {"gap", {0.0015}}}});
  Excitation excitation;
  excitation.largest_displacement = 0.002;
  excitation.highest_frequency = 10.0;
  excitation.highest_rate = 0.05;
  excitation.dt = 0.002;
  const auto menu = experimentMenu(excitation);
  for (const Experiment& experiment : menu) {
    EXPECT_LE(experiment.displacement.cwiseAbs().maxCoeff(), 0.002 * (1.0 + 1e-9)) << experiment.description;
  }
  const Discrimination fast = mostTelling(menu, spring, dashpot, 1.0);
  const Discrimination wide = mostTelling(menu, spring, stop, 1.0);
  ASSERT_NE(fast.experiment, nullptr);
  ASSERT_NE(wide.experiment, nullptr);
  EXPECT_GE(wide.experiment->displacement.cwiseAbs().maxCoeff(), 0.0015);
  EXPECT_GT(fast.difference, 0.0);
}

}  // namespace
}  // namespace rubber_suspension
