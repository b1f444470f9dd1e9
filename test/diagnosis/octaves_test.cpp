// Shares of octaves in the energy of forces.
#include "diagnosis/hypotheses/octaves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::test {
namespace {

constexpr double kDt = 0.002;  // s

// The octaves are those below 1/16 Hz, then from 2^-4 Hz on.
constexpr std::size_t octaveFrom(int power) { return static_cast<std::size_t>(power + 5); }

Eigen::VectorXd sine(double frequency, double amplitude) {
  return amplitude * (2.0 * element::kPi * frequency * kDt * Eigen::ArrayXd::LinSpaced(8192, 0.0, 8191.0)).sin();
}

TEST(OctaveShares, AreWhereTheSinesAre) {
  const std::vector<double> shares = diagnosis::octaveShares(sine(5.7, 3.0) + sine(50.0, 1.0), kDt);
  // A line leaks by 1/n into the n-th line beside it: at 0.06 Hz a line less than 1 % beyond its octave.
  EXPECT_NEAR(shares[octaveFrom(2)], 0.9, 0.01);
  EXPECT_NEAR(shares[octaveFrom(5)], 0.1, 0.01);
  EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1.0, 1e-12);
}

TEST(OctaveShares, CountAMeanBelowAllOctaves) {
  EXPECT_NEAR(diagnosis::octaveShares(Eigen::VectorXd::Constant(4096, 2.0), kDt).front(), 1.0, 1e-12);
}

TEST(OctaveShares, AreNoneWithoutEnergy) {
  EXPECT_TRUE(diagnosis::octaveShares(Eigen::VectorXd::Zero(64), kDt).empty());
  const double never = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(diagnosis::octaveShares(Eigen::VectorXd::Constant(64, never), kDt).empty());
}

}  // namespace
}  // namespace rubber_suspension::test
