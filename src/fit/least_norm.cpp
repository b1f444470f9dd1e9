// Least squares of least norm by a complete orthogonal decomposition.
#include "fit/least_norm.h"

#include <Eigen/QR>

namespace rubber_suspension::fit {

Eigen::VectorXd solveLeastNorm(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

Eigen::MatrixXd solveLeastNorm(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

}  // namespace rubber_suspension::fit
