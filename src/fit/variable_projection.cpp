// Variable projection by products of columns.
#include "fit/variable_projection.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "numerics/bounded_least_squares.h"
#include "numerics/gram.h"
#include "numerics/least_squares.h"

namespace rubber_suspension::fit {

ModelFit VariableProjection::fitAt(const Eigen::VectorXd& search) {
  model_.evaluate(search);
  const Eigen::Index size = model_.basis().cols();
  Eigen::MatrixXd columns(force_.size(), size + 1);
  columns << model_.basis()(rows_, Eigen::all), force_ - model_.rest()(rows_);
  const Eigen::MatrixXd products = numerics::gramOf(columns);
  ModelFit fit;
  fit.search = search;
  fit.coefficients = numerics::nonNegativeLeastSquares(products.topLeftCorner(size, size),
                                                       products.col(size).head(size), model_.signedColumns());
  fit.residual = columns.col(size) - columns.leftCols(size) * fit.coefficients;
  return fit;
}

double VariableProjection::at(const Eigen::VectorXd& search) {
  try {
    last_ = fitAt(search);
    return last_.residual.squaredNorm();
  } catch (const std::invalid_argument&) {  // values that a law does not accept together
    return std::numeric_limits<double>::infinity();
  }
}

numerics::SumOfSquares::Slope VariableProjection::slope() {
  std::vector<Eigen::Index> taken;  // columns of the basis that are not held at zero
  for (Eigen::Index i = 0; i < last_.coefficients.size(); ++i) {
    if (last_.coefficients[i] != 0.0 || model_.signedColumns()[static_cast<std::size_t>(i)]) {
      taken.push_back(i);
    }
  }
  const auto basis = static_cast<Eigen::Index>(taken.size());
  const Eigen::Index unknowns = last_.search.size();
  Eigen::MatrixXd columns(force_.size(), basis + unknowns);
  columns << model_.basis()(rows_, taken), derivatives(last_);
  const Eigen::MatrixXd products = numerics::gramOf(columns);
  const Eigen::VectorXd moments = columns.transpose() * last_.residual;
  const Eigen::VectorXd scale = products.diagonal().head(basis).array().max(1e-300).rsqrt();
  const Eigen::MatrixXd of_basis = scale.asDiagonal() * products.topLeftCorner(basis, basis) * scale.asDiagonal();
  const Eigen::MatrixXd shared = products.topRightCorner(basis, unknowns);
  // Part of the derivatives within the basis, in its coefficients.
  const Eigen::MatrixXd shares =
      scale.asDiagonal() * numerics::solveLeastNorm(of_basis, Eigen::MatrixXd(scale.asDiagonal() * shared));
  return {shares.transpose() * moments.head(basis) - moments.tail(unknowns),
          products.bottomRightCorner(unknowns, unknowns) - shared.transpose() * shares};
}

// Of the force by the search coordinates.
Eigen::MatrixXd VariableProjection::derivatives(const ModelFit& fit) const {
  Eigen::MatrixXd derivatives(force_.size(), fit.search.size());
  for (Eigen::Index i = 0; i < derivatives.cols(); ++i) {
    derivatives.col(i) = model_.derivative(fit.search, i, fit.coefficients)(rows_);
  }
  return derivatives;
}

Eigen::MatrixXd VariableProjection::jacobian(const ModelFit& fit) {
  const auto unit = [](double coefficient) { return coefficient != 0.0 ? std::abs(coefficient) : 1.0; };
  model_.evaluate(fit.search);
  Eigen::MatrixXd jacobian(force_.size(), fit.search.size() + fit.coefficients.size());
  jacobian << derivatives(fit), model_.basis()(rows_, Eigen::all) * fit.coefficients.unaryExpr(unit).asDiagonal();
  return jacobian;
}

}  // namespace rubber_suspension::fit
