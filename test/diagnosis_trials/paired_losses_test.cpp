// Paired comparison of models, on losses whose truth is known.
#include "diagnosis/judge/paired_losses.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>

namespace rubber_suspension::diagnosis {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

// Six logs of ten blocks; model m loses shift[m] on average, each log and each block adds what chance adds.
Losses simulated(const std::vector<double>& shift, double by_log, double by_block, unsigned seed, int logs = 6) {
  constexpr int kBlocks = 10;
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  Losses losses;
  const auto models = static_cast<Eigen::Index>(shift.size());
  losses.loss.resize(models, kBlocks * logs);
  losses.weight = Eigen::VectorXd::Ones(kBlocks * logs);
  Eigen::MatrixXd of_log(models, logs);
  for (double& value : of_log.reshaped()) {
    value = by_log * normal(generator);
  }
  for (int b = 0; b < kBlocks * logs; ++b) {
    losses.cluster.push_back(b / kBlocks);
    const double common = normal(generator);  // a block that is hard is hard for all
    for (Eigen::Index m = 0; m < models; ++m) {
      losses.loss(m, b) =
          shift[static_cast<std::size_t>(m)] + of_log(m, b / kBlocks) + common + by_block * normal(generator);
    }
  }
  return losses;
}

TEST(PairedDifference, IsTheWeightedMeanOfDifferences) {
  Losses losses;
  losses.loss.resize(2, 4);
  losses.loss << 1.0, 2.0, 3.0, 4.0, 0.0, 0.0, 0.0, 0.0;
  losses.weight = Eigen::Vector4d(1.0, 1.0, 1.0, 3.0);
  losses.cluster = {0, 0, 1, 1};
  const PairedDifference difference = compare(losses, 0, 1);
  EXPECT_DOUBLE_EQ(difference.mean, 3.0);
  // Scores of the clusters: (1 - 3) + (2 - 3) = -3 and (3 - 3) + 3 (4 - 3) = 3; sqrt(2/1 (9 + 9))/6 = 1.
  EXPECT_DOUBLE_EQ(difference.standard_error, 1.0);
  EXPECT_EQ(difference.degrees_of_freedom, 1);
}

TEST(PairedDifference, OneLogTellsNothingOfChance) {
  const PairedDifference difference = compare(simulated({0.0, 1.0}, 0.0, 0.1, 1, 1), 0, 1);
  EXPECT_EQ(difference.standard_error, std::numeric_limits<double>::infinity());
  EXPECT_EQ(difference.pValueOfNoGain(), 0.5);
}

TEST(PairedDifference, PValuesAreUniformWhereNothingDiffers) {
  constexpr int kTrials = 2000;
  int below = 0;
  for (unsigned seed = 0; seed < kTrials; ++seed) {
    below += compare(simulated({0.0, 0.0}, 0.3, 0.3, seed), 0, 1).pValueOfNoGain() < 0.1 ? 1 : 0;
  }
  // Binomial: 0.1 with a standard deviation of 0.0067; three of them.
  EXPECT_THAT(below / static_cast<double>(kTrials), DoubleNear(0.1, 0.02));
}

TEST(PairedDifference, MoreBlocksOfOneLogMakeNobodySurer) {
  const Losses losses = simulated({0.0, 0.2}, 0.3, 0.01, 3);
  Losses doubled;
  doubled.loss.resize(2, 2 * losses.loss.cols());
  doubled.loss << losses.loss, losses.loss;
  doubled.weight = Eigen::VectorXd::Ones(2 * losses.loss.cols());
  doubled.cluster = losses.cluster;
  doubled.cluster.insert(doubled.cluster.end(), losses.cluster.begin(), losses.cluster.end());
  EXPECT_NEAR(compare(doubled, 0, 1).standard_error, compare(losses, 0, 1).standard_error, 1e-12);
}

// Blocks of three logs, the first model gaining by so much in each, and scatter of 0.1.
Losses gains(const std::vector<double>& of_logs) {
  constexpr int kBlocks = 8;
  Losses losses;
  losses.loss = Eigen::MatrixXd::Zero(2, kBlocks * static_cast<Eigen::Index>(of_logs.size()));
  losses.weight = Eigen::VectorXd::Ones(losses.loss.cols());
  for (std::size_t log = 0; log < of_logs.size(); ++log) {
    for (int block = 0; block < kBlocks; ++block) {
      losses.loss(0, kBlocks * static_cast<Eigen::Index>(log) + block) = -of_logs[log] + (block % 2 == 0 ? 0.1 : -0.1);
      losses.cluster.push_back(static_cast<int>(log));
    }
  }
  return losses;
}

TEST(PValueOfTwoLogs, AGainThatASecondLogRepeatsIsNoChanceHoweverItDiffers) {
  const Losses losses = gains({0.6, 0.6, 1.9});
  EXPECT_LT(pValueOfTwoLogs(losses, 0, 1), 1e-4);
  EXPECT_GT(compare(losses, 0, 1).pValueOfNoGain(), 0.05);  // two degrees of freedom and a log that stands out
}

TEST(PValueOfTwoLogs, ALogWithoutGainSaysNothingAgainstIt) {
  EXPECT_LT(pValueOfTwoLogs(gains({0.6, 0.0, 1.9, 0.0}), 0, 1), 1e-4);
}

TEST(PValueOfTwoLogs, OneLogIsNotEnough) {
  EXPECT_GT(pValueOfTwoLogs(gains({0.0, 0.0, 1.9}), 0, 1), 0.5);
  EXPECT_EQ(pValueOfTwoLogs(gains({1.9}), 0, 1), 0.5);
}

TEST(PValueOfTwoLogs, ALogThatSpeaksLouderForTheOtherOutweighsThem) {
  EXPECT_EQ(pValueOfTwoLogs(gains({0.6, -1.9, 0.6}), 0, 1), 1.0);
}

TEST(PValueOfTwoLogs, IsRarelySmallWhereNothingDiffers) {
  constexpr int kTrials = 2000;
  int below = 0;
  for (unsigned seed = 0; seed < kTrials; ++seed) {
    below += pValueOfTwoLogs(simulated({0.0, 0.0}, 0.0, 0.3, seed), 0, 1) < 0.1 ? 1 : 0;
  }
  // Two of six uniform p-values below 0.1/5: binomial, 0.0057; three standard deviations of 0.0017 above it. Those of
  // t with nine degrees of freedom are uniform.
  EXPECT_LT(below / static_cast<double>(kTrials), 0.0057 + 3 * 0.0017);
}

TEST(LogarithmicLoss, CountsFactorsAboveTheNoise) {
  Eigen::MatrixXd errors(2, 2);
  errors << 4.0, 1e-9, 1.0, 1e-12;
  const Eigen::MatrixXd loss = logarithmicLoss(errors, 1e-4);
  EXPECT_NEAR(loss(0, 0) - loss(1, 0), std::log(2.0), 1e-4);
  EXPECT_NEAR(loss(0, 1) - loss(1, 1), 0.0, 1e-5);  // both are below the noise
}

}  // namespace
}  // namespace rubber_suspension::diagnosis
