// The gap, its noise floor, and the share of the gap that a better model closes.
#include "rubber_suspension/gap/gap.h"

#include "rubber_suspension/element/constants.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

TEST(Gap, IsTheRelativeRmsError) {
  EXPECT_DOUBLE_EQ(gap::relativeGap({1.0, -1.0, 1.0, -1.0}, {1.5, -0.5, 0.5, -1.5}), 0.5);
  EXPECT_EQ(gap::relativeGap({1.0, 2.0}, {1.0, 2.0}), 0.0);
  EXPECT_THROW(gap::relativeGap({1.0, 1.0}, {1.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(gap::relativeGap({1.0, 2.0}, {1.0}), std::invalid_argument);
  EXPECT_THROW(gap::relativeGap({}, {}), std::invalid_argument);
}

TEST(Gap, IsTheSameOfResiduals) {
  const std::vector<double> measured = {3.0, -1.0, 2.0, 7.0};
  const std::vector<double> simulated = {2.5, -1.5, 2.0, 6.0};
  const Eigen::Map<const Eigen::VectorXd> force(measured.data(), 4);
  const Eigen::Map<const Eigen::VectorXd> model(simulated.data(), 4);
  EXPECT_NEAR(gap::gapOfResidual(force - model, gap::standardDeviation(force)), gap::relativeGap(measured, simulated),
              1e-15);
}

TEST(Gap, AddsUpWithItsFloorInSquares) {
  EXPECT_DOUBLE_EQ(gap::residualAboveFloor(0.05, 0.03), 0.04);
  EXPECT_EQ(gap::residualAboveFloor(0.03, 0.05), 0.0) << "a gap below the floor is noise";
  EXPECT_DOUBLE_EQ(gap::residualAboveFloor(0.05, 0.0), 0.05);
}

TEST(Gap, IsClosedByTheShareAboveTheFloor) {
  EXPECT_DOUBLE_EQ(gap::closedFraction(0.21, 0.06, 0.01), 0.75);
  EXPECT_DOUBLE_EQ(gap::closedFraction(0.21, 0.41, 0.01), -1.0) << "a worse model opens it";
  EXPECT_DOUBLE_EQ(gap::closedFraction(0.02, 0.0, 0.01), gap::kMostClosed) << "the floor was taken for too high";
  EXPECT_EQ(gap::closedFraction(0.01, 0.0, 0.01), 0.0) << "there is nothing to close";
}

log::Record noisySine(double noise) {
  constexpr Eigen::Index kSize = 8000;
  log::Record record;
  record.dt = 1e-3;
  record.highest_frequency = 2.0;
  record.displacement = 1e-3 * (2.0 * element::kPi * 2e-3 * Eigen::ArrayXd::LinSpaced(kSize, 0.0, kSize - 1.0)).sin();
  std::mt19937 generator(3);
  std::normal_distribution<double> normal(0.0, noise);
  record.force = 1e6 * record.displacement + Eigen::VectorXd::NullaryExpr(kSize, [&] { return normal(generator); });
  record.force_deviation = gap::standardDeviation(record.force);
  return record;
}

TEST(Gap, OfPartsIsThatOfTheWhole) {
  const log::Record record = noisySine(10.0);
  const Eigen::VectorXd simulated = 0.9e6 * record.displacement;
  const auto parts = gap::partErrors({record}, {simulated});
  EXPECT_EQ(parts.size(), 10U);
  // The ten parts of 8000 samples have equal sizes, so the mean of their errors is that of all samples, up to rounding.
  EXPECT_NEAR(gap::gapOfParts(parts), gap::gapOfResidual(record.force - simulated, record.force_deviation), 1e-12);
}

TEST(Gap, HasTheFloorOfWhiteNoise) {
  const log::Record record = noisySine(10.0);
  const double floor = gap::whiteNoiseFloor(record, record.force - 1e6 * record.displacement);
  EXPECT_NEAR(floor, 10.0 / record.force_deviation,
              0.1 * floor);  // from the median of some 100 averaged spectral lines
  // Noise in the model must not raise the noise floor above the noise of the measured force.
  Eigen::VectorXd noisier = record.force - 1e6 * record.displacement;
  noisier *= 5.0;
  EXPECT_LT(gap::whiteNoiseFloor(record, noisier), 1.1 * floor);
}

}  // namespace
}  // namespace rubber_suspension
