// The covariance of estimates with autocorrelated residuals equals its definition by dense matrices.
#include "fit/residual_covariance.h"

#include <Eigen/LU>

#include "support/test.h"

namespace rubber_suspension {
namespace {

// Returns J'OJ for one run of samples, with J the Jacobian and O = s^2 A^-1 A^-T the covariance of the residuals.
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
  model.coefficients = Eigen::Vector3d(-1.1, 0.5, -0.2);  // the filter is stable
  model.innovation = 0.7;
  const std::vector<Eigen::Index> runs = {600, 2, 256};  // the recursion has blocks of 256
  srand(1);
  const Eigen::MatrixXd jacobian = Eigen::MatrixXd::Random(858, 4);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(4, 4);
  Eigen::Index begin = 0;
  for (const Eigen::Index length : runs) {
    expected += denseCovariance(jacobian.middleRows(begin, length), model);
    begin += length;
  }
  // The tolerance covers sums of 858 terms, which the filter amplifies by less than ten.
  EXPECT_LT((fit::projectedCovariance(jacobian, runs, model) - expected).norm(), 1e-12 * expected.norm());
}

}  // namespace
}  // namespace rubber_suspension
