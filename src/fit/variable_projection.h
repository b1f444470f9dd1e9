// Least squares of a ForceModel over its nonlinear unknowns alone.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/force_model.h"
#include "numerics/trust_region.h"

namespace rubber_suspension::fit {

/// The eliminated coefficients at some search coordinates, and what is left.
struct ModelFit {
  Eigen::VectorXd search;
  Eigen::VectorXd coefficients;  ///< of the basis of the ForceModel
  Eigen::VectorXd residual;      ///< [N]
};

/// The sum is of measured less simulated force [N^2], by the search coordinates, with the best coefficients for each.
/// Its slope leaves out a term that is across the residual (L. Kaufman, BIT 15 (1975) 49-57), so the gradient is exact,
/// and so is the optimum.
class VariableProjection final : public numerics::SumOfSquares {
 public:
  /// `force`: the measured one at `rows` of the model, those that are compared. All must outlive this.
  VariableProjection(ForceModel& model, const Eigen::VectorXd& force, const std::vector<Eigen::Index>& rows)
      : model_(model), force_(force), rows_(rows), unit_(force.squaredNorm()) {}

  double at(const Eigen::VectorXd& search) override;
  Slope slope() override;
  double unit() const override { return unit_; }
  double rounding() const override { return 1e-21; }

  ModelFit fitAt(const Eigen::VectorXd& search);
  /// Derivatives of the force by the search coordinates, then by relative changes of the coefficients, or by the
  /// coefficients themselves where they are zero; one row for each sample that is compared.
  Eigen::MatrixXd jacobian(const ModelFit& fit);

 private:
  Eigen::MatrixXd derivatives(const ModelFit& fit) const;

  ForceModel& model_;
  const Eigen::VectorXd& force_;
  const std::vector<Eigen::Index>& rows_;
  double unit_;
  ModelFit last_;  // where the sum was asked for last, like the model
};

}  // namespace rubber_suspension::fit
