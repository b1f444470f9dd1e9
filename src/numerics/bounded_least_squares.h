// Least squares with bounds on each unknown, from the normal equations: the solver of all fits.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rubber_suspension::numerics {

/// Minimises x'Gx/2 - b'x subject to lower <= x <= upper, G symmetric and positive semidefinite, by an active set
/// (Lawson and Hanson 1974; Stark and Parker 1995 for two-sided bounds). In directions that G does not determine, x is
/// the admissible point nearest to 0, within the accuracy of a ridge of 1e-9 of G's diagonal. Sizes up to some tens.
Eigen::VectorXd boundedLeastSquares(const Eigen::MatrixXd& gram, const Eigen::VectorXd& moment,
                                    const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

/// Minimises x'Gx/2 - b'x subject to 0 <= x_i where signed_unknown[i] is false. Without a ridge, so exact to rounding,
/// by a rank-revealing decomposition: collinear columns get the solution of least norm, a column of zeros x_i = 0.
Eigen::VectorXd nonNegativeLeastSquares(const Eigen::MatrixXd& gram, const Eigen::VectorXd& moment,
                                        const std::vector<bool>& signed_unknown);

}  // namespace rubber_suspension::numerics
