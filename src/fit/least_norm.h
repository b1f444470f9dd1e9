// Least squares of least norm, where columns may be collinear.
#pragma once

#include <Eigen/Core>

namespace rubber_suspension::fit {

/// Of the x with least |A x - b| the one of least norm, so that collinear columns share. Eigen's rank-revealing
/// decomposition takes ten seconds to compile wherever it is used: this is the one place.
Eigen::VectorXd solveLeastNorm(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::MatrixXd solveLeastNorm(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace rubber_suspension::fit
