// Bounded least squares: optimality conditions of random problems, bounds, collinear columns.
#include "numerics/bounded_least_squares.h"

#include "support/test.h"

namespace rubber_suspension {
namespace {

Eigen::MatrixXd randomMatrix(Eigen::Index rows, Eigen::Index columns, std::mt19937& generator) {
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(generator); });
}

TEST(BoundedLeastSquares, MeetsTheConditionsOfOptimality) {
  std::mt19937 generator(7);
  for (int problem = 0; problem < 200; ++problem) {
    const Eigen::Index unknowns = 2 + problem % 12;
    const Eigen::MatrixXd a = randomMatrix(3 * unknowns, unknowns, generator);
    const Eigen::VectorXd y = randomMatrix(3 * unknowns, 1, generator);
    const Eigen::MatrixXd gram = a.transpose() * a;
    const Eigen::VectorXd moment = a.transpose() * y;
    const Eigen::VectorXd lower = Eigen::VectorXd::Constant(unknowns, -0.1);
    const Eigen::VectorXd upper = Eigen::VectorXd::Constant(unknowns, 0.15);
    const Eigen::VectorXd x = numerics::boundedLeastSquares(gram, moment, lower, upper);
    const Eigen::VectorXd descent = moment - gram * x;
    // The ridge is 1e-9 of the diagonal, so it shifts the gradient by at most 1e-9 of the diagonal times the bound.
    const double tolerance = 1e-8 * gram.diagonal().maxCoeff();
    for (Eigen::Index i = 0; i < unknowns; ++i) {
      ASSERT_GE(x[i], lower[i]);
      ASSERT_LE(x[i], upper[i]);
      if (x[i] > lower[i]) {
        EXPECT_GE(descent[i], -tolerance) << "problem " << problem;
      }
      if (x[i] < upper[i]) {
        EXPECT_LE(descent[i], tolerance) << "problem " << problem;
      }
    }
  }
}

TEST(BoundedLeastSquares, LeavesAnEmptyColumnAtNothing) {
  Eigen::MatrixXd gram = Eigen::MatrixXd::Identity(3, 3);
  gram(1, 1) = 0.0;
  const Eigen::Vector3d moment(1.0, 0.0, -2.0);
  const Eigen::Vector3d infinite = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  const Eigen::VectorXd x = numerics::boundedLeastSquares(gram, moment, -infinite, infinite);
  EXPECT_NEAR(x[0], 1.0, 1e-8);
  EXPECT_EQ(x[1], 0.0);
  EXPECT_NEAR(x[2], -2.0, 1e-8);
}

TEST(BoundedLeastSquares, SplitsBetweenEqualColumnsWithoutBlowingUp) {
  const Eigen::MatrixXd gram = Eigen::MatrixXd::Constant(2, 2, 4.0);
  const Eigen::Vector2d moment(4.0, 4.0);
  const Eigen::Vector2d infinite = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  const Eigen::VectorXd x = numerics::boundedLeastSquares(gram, moment, Eigen::Vector2d::Zero(), infinite);
  EXPECT_NEAR(x.sum(), 1.0, 1e-6);
  EXPECT_LE(x.maxCoeff(), 1.0 + 1e-6);
}

TEST(NonNegativeLeastSquares, BoundsOnlyWhatHasNoSign) {
  const Eigen::Matrix3d gram = Eigen::Matrix3d::Identity();
  const Eigen::Vector3d moment(-1.0, -2.0, 3.0);
  const Eigen::VectorXd x = numerics::nonNegativeLeastSquares(gram, moment, {false, true, false});
  EXPECT_EQ(x[0], 0.0);
  EXPECT_DOUBLE_EQ(x[1], -2.0);
  EXPECT_DOUBLE_EQ(x[2], 3.0);
}

// Equal columns that are both free from the start share the value by least norm. A column freed later would get zero.
TEST(NonNegativeLeastSquares, LetsEqualColumnsOfAnySignShareAlike) {
  const Eigen::MatrixXd gram = Eigen::MatrixXd::Constant(2, 2, 4.0);
  const Eigen::VectorXd x = numerics::nonNegativeLeastSquares(gram, Eigen::Vector2d(4.0, 4.0), {true, true});
  EXPECT_NEAR(x[0], 0.5, 1e-12);  // tolerance for rounding
  EXPECT_NEAR(x[1], 0.5, 1e-12);
}

// Without a ridge, random problems meet their optimality conditions up to rounding.
TEST(NonNegativeLeastSquares, IsExact) {
  std::mt19937 generator(11);
  for (int problem = 0; problem < 200; ++problem) {
    const Eigen::Index unknowns = 2 + problem % 8;
    const Eigen::MatrixXd a = randomMatrix(4 * unknowns, unknowns, generator);
    const Eigen::VectorXd y = randomMatrix(4 * unknowns, 1, generator);
    std::vector<bool> signed_unknown(static_cast<std::size_t>(unknowns), false);
    signed_unknown.back() = true;
    const Eigen::VectorXd x = numerics::nonNegativeLeastSquares(a.transpose() * a, a.transpose() * y, signed_unknown);
    const Eigen::VectorXd descent = a.transpose() * (y - a * x);
    // The active-set method has a tolerance of 1e-11 of the largest moment, for columns of length 1.
    const double tolerance = 1e-10 * (a.transpose() * y).cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < unknowns; ++i) {
      const bool free = signed_unknown[static_cast<std::size_t>(i)] || x[i] > 0.0;
      EXPECT_GE(x[i], signed_unknown[static_cast<std::size_t>(i)] ? -HUGE_VAL : 0.0);
      EXPECT_LE(descent[i], tolerance) << "problem " << problem;
      EXPECT_GE(descent[i], free ? -tolerance : -HUGE_VAL) << "problem " << problem;
    }
  }
}

}  // namespace
}  // namespace rubber_suspension
