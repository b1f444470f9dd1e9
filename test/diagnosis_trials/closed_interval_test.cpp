// The interval of the closed fraction, by resampling.
#include "diagnosis/judge/closed_interval.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace rubber_suspension {
namespace {

constexpr double kFloor = 0.01;

// Twenty parts of a log whose gaps scatter by some percent, and the same with a tenth of the squared error.
std::vector<gap::PartError> parts(double mean, double scatter) {
  std::mt19937 generator(2);
  std::normal_distribution<double> normal(0.0, scatter);
  std::vector<gap::PartError> result;
  for (int i = 0; i < 20; ++i) {
    result.push_back({mean * std::exp(normal(generator)), 0.05});
  }
  return result;
}

TEST(ClosedInterval, HoldsTheClosedFraction) {
  const auto before = parts(0.04, 0.3);
  const auto after = parts(0.004, 0.3);
  const double closed = gap::closedFraction(gap::gapOfParts(before), gap::gapOfParts(after), kFloor);
  const auto interval = diagnosis::closedInterval(before, after, kFloor, 400, 1);
  EXPECT_LT(interval[0], closed);
  EXPECT_GT(interval[1], closed);
}

TEST(ClosedInterval, IsWiderWhereThePartsDiffer) {
  const auto width = [](double scatter) {
    // Only the model's errors scatter: paired parts that scatter alike would cancel.
    const auto interval = diagnosis::closedInterval(parts(0.04, 0.0), parts(0.01, scatter), kFloor, 400, 1);
    return interval[1] - interval[0];
  };
  EXPECT_GT(width(1.0), 2.0 * width(0.1));
}

TEST(ClosedInterval, IsTheSameForTheSameSeed) {
  const auto before = parts(0.04, 0.3);
  const auto after = parts(0.004, 0.3);
  EXPECT_EQ(diagnosis::closedInterval(before, after, kFloor, 100, 7),
            diagnosis::closedInterval(before, after, kFloor, 100, 7));
}

// Logs of which a law leaves these shares of a gap of 0.1.
std::vector<diagnosis::LogErrors> logsLeft(const std::vector<double>& shares) {
  std::vector<diagnosis::LogErrors> logs;
  for (const double share : shares) {
    logs.push_back({0.01, 0.01 * share * share + 0.0001, kFloor});
  }
  return logs;
}

std::array<double, 2> onFurtherLogs(const std::vector<double>& shares) {
  return diagnosis::closedOnFurtherLogs(logsLeft(shares), 400, 1);
}

TEST(ClosedOnFurtherLogs, IsSurerWithMoreLogsAndWhereTheyAgree) {
  const double one = onFurtherLogs({0.2})[0];
  const double alike = onFurtherLogs(std::vector<double>(8, 0.2))[0];
  const double apart = onFurtherLogs({0.05, 0.8, 0.05, 0.8, 0.05, 0.8, 0.05, 0.8})[0];  // 0.2 on average
  EXPECT_GT(alike, one);
  EXPECT_GT(alike, apart);
}

TEST(ClosedOnFurtherLogs, OfALawAtWorkIsNeverBelowNothing) {
  for (const double share : {0.5, 0.9, 1.0, 1.5}) {
    const auto interval = onFurtherLogs({share, share});
    EXPECT_GT(interval[0], 0.0) << share;
    EXPECT_LE(interval[0], interval[1]) << share;
  }
}

TEST(ClosedOnFurtherLogs, MayBeAllWhereNoiseIsLeft) {
  EXPECT_GE(onFurtherLogs({0.0, 0.05})[1], 1.0);
  EXPECT_LT(onFurtherLogs({0.5, 0.5})[1], 1.0);
}

// The floor is known to a factor of exp(1.96 x 0.3) = 1.8: what is left of eight logs is 1.7 and 1.9 floors.
TEST(ClosedOnFurtherLogs, MayBeAllAsFarAsTheFloorIsKnown) {
  EXPECT_GE(onFurtherLogs(std::vector<double>(8, 0.14))[1], 1.0);
  EXPECT_LT(onFurtherLogs(std::vector<double>(8, 0.16))[1], 1.0);
}

// Of rigs whose logs scatter as the prior has it, the interval holds what is closed of eight further logs in 95 of 100:
// 400 rigs, whose count of 380 has a standard deviation of 4.4.
TEST(ClosedOnFurtherLogs, CoversRigsThatAreLikeThePrior) {
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  constexpr int kRigs = 400;
  int covered = 0;
  for (int rig = 0; rig < kRigs; ++rig) {
    const double mean = -2.2;  // of the logarithm: 0.11 left
    const auto left = [&](double shift) { return std::min(1.0, std::exp(mean + shift + 0.4 * normal(generator))); };
    const std::vector<double> recorded = {left(0.0), left(0.0), left(0.0), left(0.0), left(0.0), left(0.0)};
    const double shift = 0.5 * normal(generator);
    double after = 0.0;
    for (int i = 0; i < 8; ++i) {
      after += 0.01 * std::pow(left(shift), 2) / 8.0;
    }
    const double closed = gap::closedFraction(std::hypot(0.1, kFloor), std::sqrt(after + kFloor * kFloor), kFloor);
    const auto interval = onFurtherLogs(recorded);
    covered += interval[0] <= closed && closed <= interval[1] ? 1 : 0;
  }
  EXPECT_GT(covered, 380 - 18);
}

TEST(ClosedOnFurtherLogs, KnowsNothingWithoutLogs) {
  EXPECT_EQ(onFurtherLogs({}), (std::array<double, 2>{0.0, 0.0}));
  EXPECT_EQ(diagnosis::closedOnFurtherLogs({{0.0, 0.0, 0.0, 0.0}}, 100, 1), (std::array<double, 2>{0.0, 0.0}));
}

TEST(ClosedOnFurtherLogs, TakesALawThatGivesWay) {
  const auto interval = diagnosis::closedOnFurtherLogs({{0.01, HUGE_VAL, kFloor}, {0.01, HUGE_VAL, kFloor}}, 100, 1);
  EXPECT_GT(interval[0], 0.0);
  EXPECT_LT(interval[0], 0.2);
  EXPECT_LT(interval[1], 0.7);  // as where it leaves all of the gap, give or take the scatter
}

}  // namespace
}  // namespace rubber_suspension
