// The hierarchical model: published figures, coverage of its intervals, false alarms, and components that stand out.
#include "campaign/random_effects.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace rubber_suspension {
namespace {

using campaign::Observation;
using campaign::RandomEffects;

// Fleets of components with a common mean of 0.05, of given scatter, with errors of estimate from 0.01 to 0.03.
std::vector<Observation> drawFleet(std::mt19937& generator, std::size_t components, double scatter) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> error(0.01, 0.03);
  std::vector<Observation> fleet;
  for (std::size_t i = 0; i < components; ++i) {
    const double standard_error = error(generator);
    fleet.push_back({0.05 + scatter * normal(generator) + standard_error * normal(generator), standard_error});
  }
  return fleet;
}

// BCG vaccine: log relative risks and sampling variances of 13 trials (Colditz et al., JAMA 271 (1994) 698-702), as in
// W. Viechtbauer, J. Statist. Software 36(3) (2010), sec. 3: REML gives tau^2 = 0.3132, mean -0.7145; the Q-profile
// interval of tau^2 is 0.1197 to 1.1115.
TEST(RandomEffectsModel, GivesThePublishedFiguresOfAMetaAnalysis) {
  const std::vector<std::pair<double, double>> trials = {
      {-0.8893, 0.3256}, {-1.5854, 0.1946}, {-1.3481, 0.4154}, {-1.4416, 0.0200}, {-0.2175, 0.0512},
      {-0.7861, 0.0069}, {-1.6209, 0.2230}, {0.0120, 0.0040},  {-0.4694, 0.0564}, {-1.3713, 0.0730},
      {-0.3394, 0.0124}, {0.4459, 0.5325},  {-0.0173, 0.0714}};
  std::vector<Observation> observations;
  for (const auto& [value, variance] : trials) {
    observations.push_back({value, std::sqrt(variance)});
  }
  const auto model = campaign::fitRandomEffects(observations);
  ASSERT_TRUE(model);
  // The inputs are rounded to four digits: the third of the results may differ.
  EXPECT_NEAR(model->scatter * model->scatter, 0.3132, 0.002);
  EXPECT_NEAR(model->mean, -0.7145, 0.001);
  EXPECT_NEAR(std::pow(model->scatter_interval[0], 2), 0.1197, 0.001);
  EXPECT_NEAR(std::pow(model->scatter_interval[1], 2), 1.1115, 0.01);
}

// Of 400 fleets a 95 % interval misses 20, give or take 4.4: four times that.
TEST(RandomEffectsModel, ItsIntervalsCoverWhatTheySay) {
  std::mt19937 generator(1);
  int mean_missed = 0;
  int scatter_missed = 0;
  for (int i = 0; i < 400; ++i) {
    const auto model = campaign::fitRandomEffects(drawFleet(generator, 20, 0.04));
    mean_missed += model->mean_interval[0] > 0.05 || model->mean_interval[1] < 0.05 ? 1 : 0;
    scatter_missed += model->scatter_interval[0] > 0.04 || model->scatter_interval[1] < 0.04 ? 1 : 0;
  }
  EXPECT_GE(mean_missed, 2);
  EXPECT_LE(mean_missed, 38);
  EXPECT_GE(scatter_missed, 2);
  EXPECT_LE(scatter_missed, 38);
}

TEST(RandomEffectsModel, WithoutScatterItFindsLittle) {
  std::mt19937 generator(2);
  int without = 0;
  for (int i = 0; i < 200; ++i) {
    const auto model = campaign::fitRandomEffects(drawFleet(generator, 20, 0.0));
    without += model->scatter_interval[0] > 0.0 ? 0 : 1;
    EXPECT_LT(model->scatter, 0.03);
  }
  EXPECT_GE(without, 185);  // of 200 the interval leaves out 0 in 5 by chance (one side of 95 %), and 2.2 more or less
}

// One fleet of twenty has a false alarm: of 400 these are 20, give or take 4.4. The limit by Student's distribution is
// an approximation, on the safe side or not by no more than a factor of 2.
TEST(RandomEffectsModel, RarelyTakesChanceForAComponentThatStandsOut) {
  std::mt19937 generator(3);
  for (const std::size_t components : {6U, 20U, 100U}) {
    int alarms = 0;
    for (int i = 0; i < 400; ++i) {
      const auto model = campaign::fitRandomEffects(drawFleet(generator, components, 0.04));
      bool alarm = false;
      for (const double z : model->robust_z) {
        alarm = alarm || std::abs(z) > model->z_limit;
      }
      alarms += alarm ? 1 : 0;
    }
    EXPECT_LE(alarms, 58) << components;
  }
}

TEST(RandomEffectsModel, FindsTheComponentsThatStandOut) {
  std::mt19937 generator(4);
  std::vector<Observation> fleet = drawFleet(generator, 40, 0.02);
  fleet[7].value += 0.5;
  fleet[31].value -= 0.4;
  const auto model = campaign::fitRandomEffects(fleet);
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    EXPECT_EQ(std::abs(model->robust_z[i]) > model->z_limit, i == 7 || i == 31) << i;
  }
  EXPECT_LT(model->robust_scatter, 0.04);
  EXPECT_GT(model->scatter, 0.07);  // which two outliers of 40 make: sqrt((0.5^2 + 0.4^2)/40) = 0.1
}

TEST(RandomEffectsModel, TakesAnyNumbers) {
  EXPECT_FALSE(campaign::fitRandomEffects({}));
  EXPECT_FALSE(campaign::fitRandomEffects(std::vector<Observation>(4, {1.0, 0.1})));
  const auto equal = campaign::fitRandomEffects(std::vector<Observation>(9, {1.0, 0.0}));
  EXPECT_EQ(equal->scatter, 0.0);
  EXPECT_EQ(equal->mean, 1.0);
  std::vector<Observation> one_apart(9, {1.0, 0.0});
  one_apart[3].value = 2.0;
  const auto model = campaign::fitRandomEffects(one_apart);
  EXPECT_TRUE(std::isfinite(model->mean) && std::isfinite(model->scatter) && std::isfinite(model->mean_interval[0]));
  EXPECT_NEAR(model->scatter, 1.0 / 3.0, 1e-6);  // standard deviation of 1 in 9, sqrt(9 8/9^2/8)
}

}  // namespace
}  // namespace rubber_suspension
