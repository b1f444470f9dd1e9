// Inverse of J'J; autoregressive residuals by Levinson-Durbin recursion and filtering of the Jacobian.
#include "fit/residual_covariance.h"

#include <algorithm>
#include <cmath>

#include "numerics/gram.h"
#include "numerics/symmetric.h"

namespace rubber_suspension::fit {
namespace {

constexpr Eigen::Index kLargestOrder = 30;
constexpr double kRankTolerance = 1e-12;  // relative eigenvalue of J'J, scaled to correlation form
constexpr double kPartInUnseen = 1e-3;    // component of a direction of length 1

// Returns the autocovariances at lags 0 to `lags`, from products within runs only.
Eigen::VectorXd autocovariances(const Eigen::Ref<const Eigen::VectorXd>& residuals,
                                const std::vector<Eigen::Index>& runs, Eigen::Index lags) {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(lags + 1);
  Eigen::Index begin = 0;
  for (const Eigen::Index length : runs) {
    for (Eigen::Index lag = 0; lag <= std::min(lags, length - 1); ++lag) {
      sums[lag] += residuals.segment(begin, length - lag).dot(residuals.segment(begin + lag, length - lag));
    }
    begin += length;
  }
  return sums / static_cast<double>(residuals.size());
}

// Adds a coefficient by the Levinson-Durbin recursion.
void raiseOrder(Autoregression& model, const Eigen::VectorXd& covariance) {
  const Eigen::Index order = model.coefficients.size();
  const double correlation = covariance[order + 1] + model.coefficients.dot(covariance.segment(1, order).reverse());
  const double reflection = -correlation / model.innovation;
  model.coefficients += reflection * model.coefficients.reverse().eval();
  model.coefficients.conservativeResize(order + 1);
  model.coefficients[order] = reflection;
  model.innovation *= 1.0 - reflection * reflection;
}

// Returns the Bayesian information criterion.
double criterionOf(const Autoregression& model, double samples) {
  return samples * std::log(std::max(model.innovation, 1e-300)) +
         static_cast<double>(model.coefficients.size()) * std::log(samples);
}

}  // namespace

double Covariance::standardDeviation(Eigen::Index estimate) const {
  const bool shown = std::none_of(unseen.begin(), unseen.end(), [&](const Eigen::VectorXd& direction) {
    return std::abs(direction[estimate]) > kPartInUnseen;
  });
  return shown ? std::sqrt(std::max(0.0, matrix(estimate, estimate))) : HUGE_VAL;
}

Covariance covarianceOf(const Eigen::MatrixXd& products, const Eigen::MatrixXd& noise_products) {
  const Eigen::VectorXd length = products.diagonal().cwiseMax(0.0).cwiseSqrt();
  const Eigen::VectorXd inverse = length.cwiseMax(1e-14 * length.maxCoeff()).cwiseInverse();
  const numerics::Eigensystem eigen = numerics::eigensystem(inverse.asDiagonal() * products * inverse.asDiagonal());
  Eigen::MatrixXd pseudo_inverse = Eigen::MatrixXd::Zero(length.size(), length.size());
  Covariance covariance;
  for (Eigen::Index i = 0; i < length.size(); ++i) {
    const Eigen::VectorXd direction = eigen.vectors.col(i);
    if (eigen.values[i] > kRankTolerance * eigen.values.maxCoeff()) {
      pseudo_inverse += direction * direction.transpose() / eigen.values[i];
    } else {
      covariance.unseen.push_back((inverse.asDiagonal() * direction).normalized());
    }
  }
  const Eigen::MatrixXd outer = inverse.asDiagonal() * pseudo_inverse * inverse.asDiagonal();
  covariance.matrix = outer * noise_products * outer.transpose();
  return covariance;
}

Covariance covarianceOf(const Eigen::MatrixXd& jacobian, double squares, double correlation) {
  const Eigen::MatrixXd products = jacobian.transpose() * jacobian;
  const double freedom = std::max(1.0, static_cast<double>(jacobian.rows() - jacobian.cols()));
  return covarianceOf(products, squares / freedom * correlation * products);
}

Autoregression fitAutoregression(const Eigen::Ref<const Eigen::VectorXd>& residuals,
                                 const std::vector<Eigen::Index>& runs) {
  const Eigen::Index longest = *std::max_element(runs.begin(), runs.end());
  const Eigen::Index largest_order = std::min(kLargestOrder, longest / 20);
  const Eigen::VectorXd covariance = autocovariances(residuals, runs, largest_order);
  const auto count = static_cast<double>(residuals.size());
  Autoregression model{{}, covariance[0]};
  Autoregression best = model;
  // Residuals as small as the rounding of the forces are not worth a model.
  while (model.coefficients.size() < largest_order && model.innovation > 1e-14 * covariance[0]) {
    raiseOrder(model, covariance);
    if (criterionOf(model, count) < criterionOf(best, count)) {
      best = model;
    }
  }
  return best;
}

Eigen::MatrixXd projectedCovariance(Eigen::MatrixXd columns, const std::vector<Eigen::Index>& runs,
                                    const Autoregression& model) {
  // O = s^2 A^-1 A^-T, where the triangular matrix A is the filter of the autoregression; A^-T runs backwards in time.
  const Eigen::VectorXd& coefficients = model.coefficients;
  Eigen::Index begin = 0;
  for (const Eigen::Index length : coefficients.size() > 0 ? runs : std::vector<Eigen::Index>()) {
    for (auto column : columns.middleRows(begin, length).colwise()) {
      for (Eigen::Index t = length - 2; t >= 0; --t) {
        const Eigen::Index later = std::min(coefficients.size(), length - 1 - t);
        column[t] -= coefficients.head(later).dot(column.segment(t + 1, later));
      }
    }
    begin += length;
  }
  return model.innovation * numerics::gramOf(columns);
}

double correlationFactor(const Autoregression& model, double variance) {
  const double sum = 1.0 + model.coefficients.sum();
  return variance > 0.0 ? model.innovation / (sum * sum) / variance : 1.0;
}

}  // namespace rubber_suspension::fit
