// Distribution of the energy of a force over octaves of frequency.
#include "diagnosis/hypotheses/log_table.h"
#include "rubber_suspension/element/constants.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

constexpr int kSamples = 8192;

// Returns a sine with `cycles` periods over all samples.
Eigen::VectorXd sine(double cycles, double amplitude) {
  return amplitude *
         (2.0 * element::kPi * cycles / kSamples * Eigen::ArrayXd::LinSpaced(kSamples, 0.0, kSamples - 1.0)).sin();
}

TEST(OctaveShares, AreWhereTheSinesAre) {
  const std::vector<double> shares = diagnosis::hypotheses::octaveShares(sine(90.0, 3.0) + sine(820.0, 1.0));
  EXPECT_EQ(shares.size(), 14U);        // one share for the mean, and 13 octaves from 1 cycle on
  EXPECT_NEAR(shares[7], 0.9, 1e-12);   // octave of 64 to 128 cycles
  EXPECT_NEAR(shares[10], 0.1, 1e-12);  // octave of 512 to 1024 cycles
  EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1.0, 1e-12);
}

TEST(OctaveShares, BeginWithTheMean) {
  EXPECT_NEAR(diagnosis::hypotheses::octaveShares(Eigen::VectorXd::Constant(kSamples, 2.0)).front(), 1.0, 1e-12);
}

TEST(OctaveShares, AreNoneWithoutEnergy) {
  EXPECT_TRUE(diagnosis::hypotheses::octaveShares(Eigen::VectorXd::Zero(64)).empty());
  const double never = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(diagnosis::hypotheses::octaveShares(Eigen::VectorXd::Constant(64, never)).empty());
}

}  // namespace
}  // namespace rubber_suspension::test
