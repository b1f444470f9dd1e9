// Least squares with bounds on each unknown, from the normal equations: the one solver of all fits.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rubber_suspension::numerics {

/// Minimise x'Gx/2 - b'x subject to lower <= x <= upper, G symmetric and positive semidefinite, by an active set
/// (Lawson and Hanson 1974; Stark and Parker 1995 for two-sided bounds). Directions that G does not determine stay at
/// the admissible point nearest to 0, within the accuracy of a ridge of 1e-9 of G's diagonal. Sizes up to some tens.
Eigen::VectorXd boundedLeastSquares(const Eigen::MatrixXd& gram, const Eigen::VectorXd& moment,
                                    const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

/// The same with 0 <= x_i where signed_unknown[i] is false and no bounds else; without a ridge, so exact to rounding,
/// by a decomposition that reveals the rank: collinear columns of any sign share by least norm. A column of zeros gets
/// x_i = 0.
Eigen::VectorXd nonNegativeLeastSquares(const Eigen::MatrixXd& gram, const Eigen::VectorXd& moment,
                                        const std::vector<bool>& signed_unknown);

}  // namespace rubber_suspension::numerics
