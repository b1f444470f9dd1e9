// The interface of a fitting method: a search from a start, and force and derivatives where it ended.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace rubber_suspension::fit {

/// Standard deviation of ln(value) whose 95 % interval reaches a factor of 2 to either side: a parameter is determined
/// below it.
inline const double kUndetermined = std::log(2.0) / 1.96;

/// When a search over the nonlinear unknowns is done.
struct SearchTolerances {
  static constexpr int kMostSteps = 60;
  static constexpr double kCost = 1e-10;  ///< relative change
  static constexpr double kStep = 1e-9;   ///< of the search coordinates, relative to their length
};

/// Where a search ended.
struct Optimum {
  Eigen::VectorXd search;
  double cost = 0.0;  ///< sum of squared residuals [N^2]; not finite where the simulated force is not
};

/// The eliminated coefficients at some search coordinates, and what is left.
struct ModelFit {
  Eigen::VectorXd search;
  Eigen::VectorXd coefficients;  ///< of the basis of the ForceModel
  Eigen::VectorXd residual;      ///< [N]

  double cost() const { return residual.squaredNorm(); }
};

/// How the value of a coefficient follows from its relative change: the coefficient itself, or 1 where it is zero.
inline double relativeUnit(double coefficient) { return coefficient != 0.0 ? std::abs(coefficient) : 1.0; }

/// A way to fit a ForceModel to the measured force. The Jacobian has the derivatives of the force by the search
/// coordinates, then by relative changes of the coefficients (relativeUnit), one row for each sample.
class FitMethod {
 public:
  virtual ~FitMethod() = default;

  /// The optimum that a search within the limits of the unknowns reaches from a start.
  virtual Optimum search(const Eigen::VectorXd& start) = 0;
  virtual ModelFit fitAt(const Eigen::VectorXd& search) = 0;
  virtual Eigen::MatrixXd jacobian(const ModelFit& fit) = 0;
  /// J'J, with the Jacobian or without.
  virtual Eigen::MatrixXd jacobianProducts(const ModelFit& fit) = 0;
  /// Of costs, relative to the sum of squares of the measured force.
  virtual double rounding() const = 0;
};

}  // namespace rubber_suspension::fit
