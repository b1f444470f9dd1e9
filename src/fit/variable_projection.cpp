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
  const Eigen::MatrixXd products = numerics::gramOf(model_.restAndBasis());
  const Eigen::Index size = products.cols() - 1;
  products_ = products.bottomRightCorner(size, size);
  ModelFit fit;
  fit.search = search;
  fit.coefficients = numerics::nonNegativeLeastSquares(products_, products.col(0).tail(size), model_.signedColumns());
  model_.setResidual(fit.coefficients);
  return fit;
}

double VariableProjection::at(const Eigen::VectorXd& search) {
  try {
    last_ = fitAt(search);
    return model_.residual().squaredNorm();
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
  model_.differentiate(last_.search, last_.coefficients);
  const Eigen::MatrixXd products = numerics::productOf(model_.basisToDerivatives(), model_.residualAndDerivatives());
  const Eigen::Index unknowns = last_.search.size();
  const Eigen::VectorXd scale = products_.diagonal()(taken).array().max(1e-300).rsqrt();
  const Eigen::MatrixXd of_basis = scale.asDiagonal() * products_(taken, taken) * scale.asDiagonal();
  const Eigen::MatrixXd shared = products(taken, Eigen::all).rightCols(unknowns);
  // Part of the derivatives within the basis, in its coefficients.
  const Eigen::MatrixXd shares =
      scale.asDiagonal() * numerics::solveLeastNorm(of_basis, Eigen::MatrixXd(scale.asDiagonal() * shared));
  return {shares.transpose() * products.col(0)(taken) - products.col(0).tail(unknowns),
          products.bottomRightCorner(unknowns, unknowns) - shared.transpose() * shares};
}

Eigen::MatrixXd VariableProjection::ofParameters(const ModelFit& fit, const Eigen::MatrixXd& products) {
  const Eigen::Index unknowns = fit.search.size();
  const Eigen::Index bases = fit.coefficients.size();
  Eigen::VectorXd unit = Eigen::VectorXd::Ones(unknowns + bases);
  std::vector<Eigen::Index> places;
  for (Eigen::Index i = 0; i < unknowns + bases; ++i) {
    places.push_back(i < unknowns ? products.cols() - unknowns + i : 1 + i - unknowns);
    if (i >= unknowns && fit.coefficients[i - unknowns] != 0.0) {
      unit[i] = std::abs(fit.coefficients[i - unknowns]);
    }
  }
  return unit.asDiagonal() * products(places, places) * unit.asDiagonal();
}

}  // namespace rubber_suspension::fit
