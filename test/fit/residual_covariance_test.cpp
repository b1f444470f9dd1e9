// The covariance of estimates whose residuals are autocorrelated, against the dense matrices of its definition.
#include "fit/residual_covariance.h"

#include <Eigen/LU>

#include "support/test.h"

namespace rubber_suspension {
namespace {

// J'OJ with O = s^2 A^-1 A^-T for one run.
Eigen::MatrixXd denseCovariance(const Eigen::MatrixXd& jacobian, const fit::Autoregression& model) {
  const Eigen::Index size = jacobian.rows();
  Eigen::MatrixXd filter = Eigen::MatrixXd::Identity(size, size);
  for (Eigen::Index lag = 1; lag <= std::min(model.coefficients.size(), size - 1); ++lag) {
    filter.diagonal(-lag).setConstant(model.coefficients[lag - 1]);
  }
  const Eigen::MatrixXd filtered = filter.transpose().lu().solve(jacobian);
  return model.innovation * filtered.transpose() * filtered;
}

TEST(ResidualCovariance, AgreesWithDenseMatrices) {
  fit::Autoregression model;
  model.coefficients = Eigen::Vector3d(-1.1, 0.5, -0.2);  // roots inside the unit circle
  model.innovation = 0.7;
  const std::vector<Eigen::Index> runs = {600, 2, 256};  // longer, shorter and as long as a block of the recursion
  srand(1);
  const Eigen::MatrixXd jacobian = Eigen::MatrixXd::Random(858, 4);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(4, 4);
  Eigen::Index begin = 0;
  for (const Eigen::Index length : runs) {
    expected += denseCovariance(jacobian.middleRows(begin, length), model);
    begin += length;
  }
  // The tolerance covers sums of 858 terms that the filter amplifies by less than ten.
  EXPECT_LT((fit::projectedCovariance(jacobian, runs, model) - expected).norm(), 1e-12 * expected.norm());
}

}  // namespace
}  // namespace rubber_suspension
