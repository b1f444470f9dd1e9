// The trust-region search minimises a sum of squares within limits.
#include "numerics/trust_region.h"

#include "support/test.h"

namespace rubber_suspension::numerics {
namespace {

// Rosenbrock's function with residuals 10 (y - x^2) and 1 - x, which is undefined for x > `end`.
class Valley final : public SumOfSquares {
 public:
  explicit Valley(double end = std::numeric_limits<double>::infinity()) : end_(end) {}

  double at(const Eigen::VectorXd& x) override {
    ++evaluations;
    residual_ = Eigen::Vector2d(10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]);
    jacobian_ << -20.0 * x[0], 10.0, -1.0, 0.0;
    return x[0] > end_ ? std::numeric_limits<double>::quiet_NaN() : residual_.squaredNorm();
  }
  Slope slope() override { return {jacobian_.transpose() * residual_, jacobian_.transpose() * jacobian_}; }
  double unit() const override { return 1.0; }
  double rounding() const override { return 1e-21; }

  int evaluations = 0;

 private:
  double end_;
  Eigen::Vector2d residual_;
  Eigen::Matrix2d jacobian_;
};

const Limits kWide{Eigen::Vector2d(-10.0, -10.0), Eigen::Vector2d(10.0, 10.0)};
const Eigen::Vector2d kStart(-1.2, 1.0);

TEST(TrustRegion, FollowsAValleyToItsEnd) {
  Valley valley;
  const Optimum found = searchLeast(valley, kStart, kWide);
  EXPECT_LT(found.cost, 1e-18);
  EXPECT_LT((found.search - Eigen::Vector2d(1.0, 1.0)).norm(), 1e-8);
  EXPECT_LT(valley.evaluations, 60);
}

// Along the limit x = 0.5, the minimum is at y = 0.25.
TEST(TrustRegion, EndsAtALimit) {
  Valley valley;
  const Optimum found = searchLeast(valley, kStart, {kWide.lower, Eigen::Vector2d(0.5, 10.0)});
  EXPECT_EQ(found.search[0], 0.5);
  EXPECT_NEAR(found.search[1], 0.25, 1e-6);
  EXPECT_NEAR(found.cost, 0.25, 1e-9);
}

TEST(TrustRegion, StaysWhereThereIsASum) {
  Valley valley(0.5);
  const Optimum found = searchLeast(valley, kStart, kWide);
  EXPECT_LE(found.search[0], 0.5 + 1e-6);
  EXPECT_LT(found.cost, 1.0);
}

TEST(TrustRegion, ReturnsTheStartWhereThereIsNone) {
  Valley valley(-5.0);
  const Optimum found = searchLeast(valley, kStart, kWide);
  EXPECT_FALSE(std::isfinite(found.cost));
  EXPECT_EQ(found.search, kStart);
  EXPECT_EQ(valley.evaluations, 1);
}

}  // namespace
}  // namespace rubber_suspension::numerics
