// Least squares by rank-revealing orthogonal decompositions.
#include "numerics/least_squares.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "numerics/gram.h"

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

// With C = U S V', where S^2 are the eigenvalues of C'C, the result is N = U sqrt(1 - 1/sqrt(1 + S^2)).
Eigen::MatrixXd whiteningColumns(const Eigen::MatrixXd& c) {
  constexpr double kNothing = 1e-12;  // relative to 1 and to the largest S^2; a smaller value is rounding
  if (c.cols() == 0) {
    return c;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gramOf(c));
  const Eigen::VectorXd& squares = solver.eigenvalues();
  const double least = kNothing * std::max(1.0, squares[squares.size() - 1]);
  const Eigen::Index dropped = (squares.array() <= least).count();
  Eigen::MatrixXd n = c * solver.eigenvectors().rightCols(squares.size() - dropped);
  for (Eigen::Index j = 0; j < n.cols(); ++j) {
    const double square = squares[dropped + j];
    n.col(j) *= std::sqrt((1.0 - 1.0 / std::sqrt(1.0 + square)) / square);
  }
  return n;
}

Eigen::VectorXd penaltyOfWhitening(const Eigen::MatrixXd& n) {
  Eigen::VectorXd penalty(n.cols());
  for (Eigen::Index j = 0; j < n.cols(); ++j) {
    const double square = n.col(j).squaredNorm();
    const double left = std::max(1.0 - square, 1e-9);
    penalty[j] = square / (1.0 / (left * left) - 1.0);
  }
  return penalty;
}

Eigen::MatrixXd columnsOfWhitening(const Eigen::MatrixXd& n) {
  return n * penaltyOfWhitening(n).cwiseSqrt().cwiseInverse().asDiagonal();
}

}  // namespace rubber_suspension::numerics
