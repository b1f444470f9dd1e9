// Covariance of least squares estimates whose residuals are autocorrelated.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rubber_suspension::fit {

/// An autoregressive model of residuals: r_t + sum a_i r_(t-i) = e_t, e of variance innovation.
struct Autoregression {
  std::vector<double> coefficients;
  double innovation = 0.0;
};

/// Fit by the Yule-Walker equations over independent runs (runs: lengths, in order); the order, up to
/// min(30, longest run/20), is that of the lowest Bayesian information criterion.
Autoregression fitAutoregression(const Eigen::VectorXd& residuals, const std::vector<Eigen::Index>& runs);

/// J' O J, O being the covariance of residuals that follow the autoregression, independent between runs.
Eigen::MatrixXd projectedCovariance(const Eigen::MatrixXd& jacobian, const std::vector<Eigen::Index>& runs,
                                    const Autoregression& model);

/// Variance over long times relative to white residuals: sum of all autocorrelations, from both sides.
double correlationFactor(const Autoregression& model, double variance);

}  // namespace rubber_suspension::fit
