// The interval of the closed fraction, by resampling.
#include "diagnosis/judge/closed_interval.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace rubber_suspension
