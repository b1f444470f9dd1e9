// Symmetric matrices: solutions and eigenvalues. Only their lower halves are read.
#pragma once

#include <Eigen/Core>

namespace rubber_suspension::numerics {

/// Cholesky factor L of a positive definite matrix L L'.
class Cholesky {
 public:
  explicit Cholesky(const Eigen::MatrixXd& matrix);

  /// Returns false if the matrix is not positive definite, so that the factor does not exist.
  bool exists() const { return exists_; }
  auto diagonal() const { return factor_.diagonal(); }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;

 private:
  Eigen::MatrixXd factor_;  // above the diagonal: the elements of the original matrix
  bool exists_ = false;
};

/// Solves by the decomposition L D L', so the matrix may be singular or indefinite.
Eigen::VectorXd solveSymmetric(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Eigenvalues in increasing order, with unit eigenvectors as columns.
struct Eigensystem {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
Eigensystem eigensystem(const Eigen::MatrixXd& symmetric);

}  // namespace rubber_suspension::numerics
