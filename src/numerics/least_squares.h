// Least squares by orthogonal decompositions. Eigen's decompositions are compiled only here, which takes ten seconds.
#pragma once

#include <Eigen/Core>

namespace rubber_suspension::numerics {

/// Returns the x of least norm that minimises |A x - b|. Collinear columns share their coefficient.
Eigen::VectorXd solveLeastNorm(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::MatrixXd solveLeastNorm(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Returns an x that minimises |A x - b|, with 0 for some of the columns that are collinear.
Eigen::VectorXd solveLeastSquares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Returns the x that minimises |A x - b| for columns that are known to be independent.
Eigen::VectorXd solveIndependent(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Residual of B after subtraction of the best A X, and the rank of A.
struct Remainder {
  Eigen::MatrixXd values;
  Eigen::Index rank = 0;
};
Remainder remainder(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Returns orthonormal columns with the same span. A column is dependent if its part orthogonal to the others is below
/// `least_share` of the largest column; a share of 0 means rounding.
Eigen::MatrixXd orthonormalColumns(const Eigen::MatrixXd& columns, double least_share = 0.0);

/// Whitens the sum of errors with unit variance and C times parameters with unit variance. Returns orthogonal columns N
/// such that I - N N' is the symmetric root of (I + C C')^-1. The norm of a column of N is at most 1, its limit for a
/// parameter of infinite variance.
Eigen::MatrixXd whiteningColumns(const Eigen::MatrixXd& c);

/// Returns the penalty on squared coefficients of N with which least squares equal those weighted by (I + C C')^-1.
Eigen::VectorXd penaltyOfWhitening(const Eigen::MatrixXd& n);

/// Inverts whiteningColumns(): returns columns C with the same C C'.
Eigen::MatrixXd columnsOfWhitening(const Eigen::MatrixXd& n);

}  // namespace rubber_suspension::numerics
