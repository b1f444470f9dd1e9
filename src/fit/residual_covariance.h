// Covariance of least squares estimates, whose residuals may be autocorrelated.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace rubber_suspension::fit {

/// Standard deviation of ln(value) for which the 95 % interval extends by a factor of 2 to either side. A parameter
/// with a smaller standard deviation counts as determined.
inline const double kUndetermined = std::log(2.0) / 1.96;

/// Covariance of estimates in the coordinates of a Jacobian.
struct Covariance {
  Eigen::MatrixXd matrix;
  std::vector<Eigen::VectorXd> unseen;  ///< directions on which the measurement does not depend

  /// Returns the standard deviation of an estimate; infinity if an undetermined direction contributes to it.
  double standardDeviation(Eigen::Index estimate) const;
};

/// Returns (J'J)^-1 J'OJ (J'J)^-1 from J'J and J'OJ, where J is the Jacobian and O the covariance of the residuals.
Covariance covarianceOf(const Eigen::MatrixXd& products, const Eigen::MatrixXd& noise_products);

/// Returns the covariance for white residuals with the sum of squares `squares`, multiplied by `correlation`: the
/// variance of sums of residuals relative to white residuals.
Covariance covarianceOf(const Eigen::MatrixXd& jacobian, double squares, double correlation = 1.0);

/// An autoregressive model of residuals: r_t + sum a_i r_(t-i) = e_t, where e_t is white with variance `innovation`.
struct Autoregression {
  Eigen::VectorXd coefficients;
  double innovation = 0.0;
};

/// Fits by the Yule-Walker equations over independent runs, whose lengths are `runs`. The order with the lowest
/// Bayesian information criterion is chosen, up to min(30, longest run/20).
Autoregression fitAutoregression(const Eigen::Ref<const Eigen::VectorXd>& residuals,
                                 const std::vector<Eigen::Index>& runs);

/// Returns J' O J for the columns J. O is the covariance of residuals that follow the autoregression and are
/// independent between runs.
Eigen::MatrixXd projectedCovariance(Eigen::MatrixXd columns, const std::vector<Eigen::Index>& runs,
                                    const Autoregression& model);

/// Returns the variance of sums of residuals relative to white residuals: the sum of autocorrelations at all lags.
double correlationFactor(const Autoregression& model, double variance);

}  // namespace rubber_suspension::fit
