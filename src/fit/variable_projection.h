// Least squares of a ForceModel over its nonlinear unknowns alone.
#pragma once

#include <Eigen/Core>

#include "fit/force_model.h"
#include "numerics/trust_region.h"

namespace rubber_suspension::fit {

/// The eliminated coefficients at some search coordinates; what they leave is the residual of the ForceModel.
struct ModelFit {
  Eigen::VectorXd search;
  Eigen::VectorXd coefficients;  ///< of the basis of the ForceModel
};

/// The sum is of measured less simulated force [N^2], by the search coordinates, with the best coefficients for each.
/// Its slope leaves out a term that is across the residual (L. Kaufman, BIT 15 (1975) 49-57), so the gradient is exact,
/// and so is the optimum.
class VariableProjection final : public numerics::SumOfSquares {
 public:
  /// The model has to outlive this.
  explicit VariableProjection(ForceModel& model) : model_(model), unit_(model.measured().squaredNorm()) {}

  double at(const Eigen::VectorXd& search) override;
  Slope slope() override;
  double unit() const override { return unit_; }
  double rounding() const override { return 1e-21; }

  ModelFit fitAt(const Eigen::VectorXd& search);
  /// By products of all columns of the model those of the derivatives of the force by the search coordinates, then by
  /// relative changes of the coefficients, or by the coefficients themselves where they are zero.
  static Eigen::MatrixXd ofParameters(const ModelFit& fit, const Eigen::MatrixXd& products);

 private:
  ForceModel& model_;
  double unit_;
  ModelFit last_;             // where the sum was asked for last, like the model
  Eigen::MatrixXd products_;  // of the basis there
};

}  // namespace rubber_suspension::fit
