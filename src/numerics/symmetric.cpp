// Symmetric matrices by Eigen's decompositions.
#include "numerics/symmetric.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace rubber_suspension::numerics {
namespace {

template <class Values>
Values solvedBy(const Eigen::MatrixXd& factor, const Values& b) {
  Values x = b;
  factor.triangularView<Eigen::Lower>().solveInPlace(x);
  factor.adjoint().triangularView<Eigen::Upper>().solveInPlace(x);
  return x;
}

}  // namespace

Cholesky::Cholesky(const Eigen::MatrixXd& matrix) {
  const Eigen::LLT<Eigen::MatrixXd> decomposition(matrix);
  factor_ = decomposition.matrixLLT();
  exists_ = decomposition.info() == Eigen::Success;
}

Eigen::VectorXd Cholesky::solve(const Eigen::VectorXd& b) const { return solvedBy(factor_, b); }

Eigen::MatrixXd Cholesky::solve(const Eigen::MatrixXd& b) const { return solvedBy(factor_, b); }

Eigen::VectorXd solveSymmetric(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) { return a.ldlt().solve(b); }

Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return a.ldlt().solve(b); }

Eigensystem eigensystem(const Eigen::MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace rubber_suspension::numerics
