// The map of the gap: cells of known errors, and no built-in time scale.
#include "rubber_suspension/gap/where.h"

#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/gap/gap.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr Eigen::Index kSize = 16384;
constexpr double kStiffness = 1e6;

// Returns a sine with 3 cycles in 1000 samples, then one with 9 cycles and a tenth of the amplitude. The first sine has
// nearly all of the motion, and so determines the mean frequency.
log::Record twoSines(double dt) {
  log::Record record;
  record.name = "sines";
  record.dt = dt;
  record.lowest_frequency = record.mean_frequency = 3e-3 / dt;
  record.highest_frequency = 9e-3 / dt;
  record.displacement.resize(kSize);
  for (Eigen::Index i = 0; i < kSize; ++i) {
    const double samples = static_cast<double>(i);
    record.displacement[i] = i < kSize / 2 ? 2e-3 * std::sin(2.0 * element::kPi * 3e-3 * samples)
                                           : 2e-4 * std::sin(2.0 * element::kPi * 9e-3 * samples);
  }
  record.raw_displacement = record.displacement;
  record.force = kStiffness * record.displacement;
  record.force_deviation = gap::standardDeviation(record.force);
  return record;
}

std::vector<gap::GapCell> mapOf(const log::Record& record) {
  return gap::gapMap({record}, {Eigen::VectorXd(0.1 * record.force)}, {0.01});
}

TEST(GapMap, FindsAnErrorOfStiffness) {
  const auto cells = mapOf(twoSines(1e-3));
  ASSERT_FALSE(cells.empty());
  EXPECT_EQ(cells[0].quantity, gap::Quantity::stiffness);
  EXPECT_LE(cells[0].frequency[0], 3.0);
  EXPECT_GE(cells[0].frequency[1], 3.0);
  EXPECT_GT(cells[0].share, 0.9);
  double sum = 0.0;
  for (const gap::GapCell& cell : cells) {
    sum += cell.share;
  }
  EXPECT_NEAR(sum, 1.0, 1e-9);
}

TEST(GapMap, OfASlowerTestIsTheSameAtLowerFrequencies) {
  constexpr double kSlower = 1024.0;  // a power of two, so that octaves map to octaves
  const auto fast = mapOf(twoSines(1e-3));
  const auto slow = mapOf(twoSines(kSlower * 1e-3));
  ASSERT_EQ(fast.size(), slow.size());
  for (std::size_t i = 0; i < fast.size(); ++i) {
    EXPECT_EQ(fast[i].share, slow[i].share);
    EXPECT_EQ(fast[i].quantity, slow[i].quantity);
    EXPECT_EQ(fast[i].amplitude, slow[i].amplitude);
    EXPECT_DOUBLE_EQ(fast[i].frequency[0], kSlower * slow[i].frequency[0]);
    EXPECT_DOUBLE_EQ(fast[i].noise_ratio, slow[i].noise_ratio);
  }
}

}  // namespace
}  // namespace rubber_suspension
