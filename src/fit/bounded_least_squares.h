// Least squares with bounds on each unknown, from the normal equations.
#pragma once

#include <Eigen/Core>

namespace rubber_suspension::fit {

/// Minimise x'Gx/2 - b'x subject to lower <= x <= upper, G symmetric and positive semidefinite, by an active set
/// (Lawson and Hanson 1974; Stark and Parker 1995 for two-sided bounds). Directions that G does not determine stay at
/// the admissible point nearest to 0. Sizes up to some tens.
Eigen::VectorXd boundedLeastSquares(const Eigen::MatrixXd& gram, const Eigen::VectorXd& moment,
                                    const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

}  // namespace rubber_suspension::fit
