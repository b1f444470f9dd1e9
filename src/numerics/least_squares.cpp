// Least squares by orthogonal decompositions that find the rank.
#include "numerics/least_squares.h"

#include <Eigen/QR>

namespace rubber_suspension::numerics {

Eigen::VectorXd solveLeastNorm(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

Eigen::MatrixXd solveLeastNorm(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

Eigen::VectorXd solveLeastSquares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.colPivHouseholderQr().solve(b);
}

Eigen::VectorXd solveIndependent(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.householderQr().solve(b);
}

Remainder remainder(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factor(a);
  return {b - a * factor.solve(b), factor.rank()};
}

Eigen::MatrixXd orthonormalColumns(const Eigen::MatrixXd& columns, double least_share) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factor(columns.rows(), columns.cols());
  if (least_share > 0.0) {
    factor.setThreshold(least_share);
  }
  factor.compute(columns);
  return factor.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), factor.rank());
}

}  // namespace rubber_suspension::numerics
