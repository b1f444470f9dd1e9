// Linear least squares in which some unknowns must not be negative.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rubber_suspension::fit {

/// Of the x with least |A x - b| the one of least norm, so that collinear columns share. Eigen's rank-revealing
/// decomposition takes ten seconds to compile wherever it is used: this is the one place.
Eigen::VectorXd solveLeastNorm(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::MatrixXd solveLeastNorm(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// x of least |A x - b| with x_i >= 0 where signed_unknown[i] is false; by an active set on the normal equations with
/// columns scaled to length 1 (C. L. Lawson and R. J. Hanson, Solving Least Squares Problems, 1974, ch. 23).
/// A column of zeros gets x_i = 0.
Eigen::VectorXd solveLeastSquares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b,
                                  const std::vector<bool>& signed_unknown);

/// The same from A'A, A'b and the norm |b|.
Eigen::VectorXd solveNormalEquations(const Eigen::MatrixXd& gram, const Eigen::VectorXd& moment, double norm,
                                     const std::vector<bool>& signed_unknown);

}  // namespace rubber_suspension::fit
