// Least squares by orthogonal decompositions. These are compiled only here, because that takes ten seconds.
#pragma once

#include <Eigen/Core>

namespace rubber_suspension::numerics {

/// Returns the x of least norm that minimises |A x - b|, so that collinear columns share.
Eigen::VectorXd solveLeastNorm(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::MatrixXd solveLeastNorm(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Returns an x that minimises |A x - b|, with 0 for some of several collinear columns.
Eigen::VectorXd solveLeastSquares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Minimises |A x - b| for columns known to be independent.
Eigen::VectorXd solveIndependent(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Residual of B after the best A X, and the rank of A.
struct Remainder {
  Eigen::MatrixXd values;
  Eigen::Index rank = 0;
};
Remainder remainder(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Returns orthonormal columns with the same span. A column counts as dependent if its part orthogonal to the others is
/// below this share of the largest; at 0, below rounding.
Eigen::MatrixXd orthonormalColumns(const Eigen::MatrixXd& columns, double least_share = 0.0);

/// For errors of unit variance plus C times unknowns of unit variance: returns orthogonal columns N such that I - N N'
/// is the symmetric root of (I + C C')^-1, which whitens the sum. The columns of N have a norm of at most 1, which
/// unbounded unknowns reach.
Eigen::MatrixXd whiteningColumns(const Eigen::MatrixXd& c);

/// Returns the penalty on squared unknowns of N with which least squares equal those weighted by (I + C C')^-1.
Eigen::VectorXd penaltyOfWhitening(const Eigen::MatrixXd& n);

/// Inverts whiteningColumns(): returns columns C with the same C C'.
Eigen::MatrixXd columnsOfWhitening(const Eigen::MatrixXd& n);

}  // namespace rubber_suspension::numerics
