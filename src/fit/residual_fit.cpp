// Variable projection on columns of all samples.
#include "fit/residual_fit.h"

#include <limits>
#include <stdexcept>

#include "fit/bounded_least_squares.h"
#include "numerics/least_squares.h"

namespace rubber_suspension::fit {
namespace {

// The rest of columns once the basis has taken its share, without the columns of the basis that are held at zero.
Eigen::MatrixXd withoutBasis(const ForceModel& model, const Eigen::VectorXd& coefficients,
                             const Eigen::MatrixXd& columns) {
  std::vector<Eigen::Index> taken;
  for (Eigen::Index i = 0; i < coefficients.size(); ++i) {
    if (coefficients[i] != 0.0 || model.signedColumns()[static_cast<std::size_t>(i)]) {
      taken.push_back(i);
    }
  }
  Eigen::MatrixXd basis = model.basis()(Eigen::all, taken);
  for (auto column : basis.colwise()) {
    column.normalize();
  }
  const Eigen::MatrixXd gram = basis.transpose() * basis;
  const Eigen::MatrixXd moment = basis.transpose() * columns;
  return columns - basis * numerics::solveLeastNorm(gram, moment);
}

}  // namespace

ModelFit ResidualFit::fitAt(const Eigen::VectorXd& search) {
  model_.evaluate(search);
  ModelFit fit;
  fit.search = search;
  const Eigen::MatrixXd& basis = model_.basis();
  fit.coefficients = nonNegativeLeastSquares(basis.transpose() * basis, basis.transpose() * (force_ - model_.rest()),
                                             model_.signedColumns());
  fit.residual = force_ - model_.rest() - basis * fit.coefficients;
  return fit;
}

double ResidualFit::at(const Eigen::VectorXd& search) {
  try {
    last_ = fitAt(search);
    return last_.cost();
  } catch (const std::invalid_argument&) {  // values that a law does not accept together
    return std::numeric_limits<double>::infinity();
  }
}

SumOfSquares::Slope ResidualFit::slope() {
  const Eigen::MatrixXd columns = withoutBasis(model_, last_.coefficients, derivatives(last_));
  return {-columns.transpose() * last_.residual, columns.transpose() * columns};
}

// Of the force by the search coordinates.
Eigen::MatrixXd ResidualFit::derivatives(const ModelFit& fit) const {
  Eigen::MatrixXd derivatives(model_.size(), fit.search.size());
  for (Eigen::Index i = 0; i < derivatives.cols(); ++i) {
    derivatives.col(i) = model_.derivative(fit.search, i, fit.coefficients);
  }
  return derivatives;
}

Eigen::MatrixXd ResidualFit::jacobian(const ModelFit& fit) {
  model_.evaluate(fit.search);
  Eigen::MatrixXd jacobian(model_.size(), fit.search.size() + fit.coefficients.size());
  jacobian << derivatives(fit), model_.basis() * fit.coefficients.unaryExpr(&relativeUnit).asDiagonal();
  return jacobian;
}

Eigen::MatrixXd ResidualFit::jacobianProducts(const ModelFit& fit) {
  const Eigen::MatrixXd columns = jacobian(fit);
  return columns.transpose() * columns;
}

}  // namespace rubber_suspension::fit
