// Least squares by orthogonal decompositions. Eigen's take ten seconds to compile wherever they are used: this is the
// one place.
#pragma once

#include <Eigen/Core>

namespace rubber_suspension::numerics {

/// Returns the x of least norm that minimises |A x - b|, so that collinear columns share.
Eigen::VectorXd solveLeastNorm(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::MatrixXd solveLeastNorm(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// An x with least |A x - b|, where of collinear columns some get nothing.
Eigen::VectorXd solveLeastSquares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Minimises |A x - b| for columns known to be independent.
Eigen::VectorXd solveIndependent(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// The rest of B that the best A X leaves, and the rank of A.
struct Remainder {
  Eigen::MatrixXd values;
  Eigen::Index rank = 0;
};
Remainder remainder(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Orthonormal columns that span the same as these. What is left of a column beside the others counts as nothing below
/// this share of the largest; at 0, below its rounding.
Eigen::MatrixXd orthonormalColumns(const Eigen::MatrixXd& columns, double least_share = 0.0);

/// For errors of unit variance with, beside them, columns C times unknowns of unit variance: orthogonal columns N such
/// that I - N N' is the symmetric root of (I + C C')^-1, which makes both together white. A column of N is at most 1
/// long: that of what C leaves entirely free.
Eigen::MatrixXd whiteningColumns(const Eigen::MatrixXd& c);

/// The penalty on the squares of unknowns of N by which least squares beside them leave what (I + C C')^-1 does.
Eigen::VectorXd penaltyOfWhitening(const Eigen::MatrixXd& n);

/// From N to columns that C C' is of.
Eigen::MatrixXd columnsOfWhitening(const Eigen::MatrixXd& n);

}  // namespace rubber_suspension::numerics
