// Fit by the residuals of all samples: for any model, exact down to the last bits.
#pragma once

#include "fit/fit_method.h"
#include "fit/force_model.h"

namespace rubber_suspension::fit {

/// Variable projection with columns of all samples, the search by Ceres.
class ResidualFit final : public FitMethod {
 public:
  /// Both must outlive this.
  ResidualFit(ForceModel& model, const Eigen::VectorXd& force) : model_(model), force_(force) {}

  Optimum search(const Eigen::VectorXd& start) override;
  ModelFit fitAt(const Eigen::VectorXd& search) override;
  Eigen::MatrixXd jacobian(const ModelFit& fit) override;
  Eigen::MatrixXd jacobianProducts(const ModelFit& fit) override;
  double rounding() const override { return 1e-20; }

 private:
  ForceModel& model_;
  const Eigen::VectorXd& force_;
};

}  // namespace rubber_suspension::fit
