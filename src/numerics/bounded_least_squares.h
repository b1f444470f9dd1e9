// Least squares with bounds on each variable, from the normal equations. All fits use this solver.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rubber_suspension::numerics {

/// Minimises x'Gx/2 - b'x subject to lower <= x <= upper, with a symmetric, positive semidefinite G, by an active-set
/// method (Lawson and Hanson 1974; Stark and Parker 1995 for two-sided bounds). Where G does not determine x, it is the
/// admissible point nearest to 0, up to a ridge of 1e-9 of G's diagonal.
Eigen::VectorXd boundedLeastSquares(const Eigen::MatrixXd& gram, const Eigen::VectorXd& moment,
                                    const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

/// Minimises x'Gx/2 - b'x subject to x_i >= 0 where signed_unknown[i] is false. A rank-revealing decomposition makes
/// the result exact to rounding; collinear columns have the solution of least norm.
Eigen::VectorXd nonNegativeLeastSquares(const Eigen::MatrixXd& gram, const Eigen::VectorXd& moment,
                                        const std::vector<bool>& signed_unknown);

}  // namespace rubber_suspension::numerics
