// The interface of a way to fit a ForceModel: a sum of squares to search, and force and derivatives where that ended.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "fit/trust_region.h"

namespace rubber_suspension::fit {

/// Standard deviation of ln(value) whose 95 % interval reaches a factor of 2 to either side: a parameter is determined
/// below it.
inline const double kUndetermined = std::log(2.0) / 1.96;

/// The eliminated coefficients at some search coordinates, and what is left.
struct ModelFit {
  Eigen::VectorXd search;
  Eigen::VectorXd coefficients;  ///< of the basis of the ForceModel
  Eigen::VectorXd residual;      ///< [N]

  double cost() const { return residual.squaredNorm(); }
};

/// How the value of a coefficient follows from its relative change: the coefficient itself, or 1 where it is zero.
inline double relativeUnit(double coefficient) { return coefficient != 0.0 ? std::abs(coefficient) : 1.0; }

/// Variable projection (see ForceModel): the sum is of measured less simulated force [N^2], by the search coordinates,
/// with the best coefficients for each. Its slope leaves out a term that is across the residual (L. Kaufman, BIT 15
/// (1975) 49-57), so the gradient is exact, and so is the optimum. The Jacobian has the derivatives of the force by the
/// search coordinates, then by relative changes of the coefficients (relativeUnit), one row for each sample.
class FitMethod : public SumOfSquares {
 public:
  virtual ModelFit fitAt(const Eigen::VectorXd& search) = 0;
  virtual Eigen::MatrixXd jacobian(const ModelFit& fit) = 0;
  /// J'J, with the Jacobian or without.
  virtual Eigen::MatrixXd jacobianProducts(const ModelFit& fit) = 0;
};

}  // namespace rubber_suspension::fit
