// Covariance of least squares estimates, whose residuals may be autocorrelated.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace rubber_suspension::fit {

/// Standard deviation of ln(value) whose 95 % interval reaches a factor of 2 to either side. A parameter is determined
/// if its standard deviation is less.
inline const double kUndetermined = std::log(2.0) / 1.96;

/// Covariance of estimates in the coordinates of a Jacobian.
struct Covariance {
  Eigen::MatrixXd matrix;
  std::vector<Eigen::VectorXd> unseen;  ///< directions that the measurement does not show at all

  /// Returns infinity if an undetermined direction contributes to the estimate.
  double standardDeviation(Eigen::Index estimate) const;
};

/// Returns (J'J)^-1 J'OJ (J'J)^-1 from J'J and J'OJ, J being the Jacobian and O the covariance of the residuals.
Covariance covarianceOf(const Eigen::MatrixXd& products, const Eigen::MatrixXd& noise_products);

/// Returns the covariance for white residuals with this sum of squares, except that the variance of their sums is
/// `correlation` times that of white ones.
Covariance covarianceOf(const Eigen::MatrixXd& jacobian, double squares, double correlation = 1.0);

/// An autoregressive model of residuals: r_t + sum a_i r_(t-i) = e_t, e of variance innovation.
struct Autoregression {
  Eigen::VectorXd coefficients;
  double innovation = 0.0;
};

/// Fits by the Yule-Walker equations over independent runs (runs: lengths, in order); the order, up to min(30, longest
/// run/20), has the lowest Bayesian information criterion.
Autoregression fitAutoregression(const Eigen::Ref<const Eigen::VectorXd>& residuals,
                                 const std::vector<Eigen::Index>& runs);

/// Returns J' O J of these columns, O being the covariance of residuals that follow the autoregression, independent
/// between runs.
Eigen::MatrixXd projectedCovariance(Eigen::MatrixXd columns, const std::vector<Eigen::Index>& runs,
                                    const Autoregression& model);

/// Returns the variance over long times relative to white residuals: sum of all autocorrelations, from both sides.
double correlationFactor(const Autoregression& model, double variance);

}  // namespace rubber_suspension::fit
