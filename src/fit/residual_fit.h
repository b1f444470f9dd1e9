// Fit by the residuals of all samples: for any model, exact down to the last bits.
#pragma once

#include "fit/fit_method.h"
#include "fit/force_model.h"

namespace rubber_suspension::fit {

/// Variable projection with columns of all samples.
class ResidualFit final : public FitMethod {
 public:
  /// Both must outlive this.
  ResidualFit(ForceModel& model, const Eigen::VectorXd& force)
      : model_(model), force_(force), unit_(force.squaredNorm()) {}

  double at(const Eigen::VectorXd& search) override;
  Slope slope() override;
  double unit() const override { return unit_; }
  double rounding() const override { return 1e-21; }

  ModelFit fitAt(const Eigen::VectorXd& search) override;
  Eigen::MatrixXd jacobian(const ModelFit& fit) override;
  Eigen::MatrixXd jacobianProducts(const ModelFit& fit) override;

 private:
  Eigen::MatrixXd derivatives(const ModelFit& fit) const;

  ForceModel& model_;
  const Eigen::VectorXd& force_;
  double unit_;
  ModelFit last_;  // where the sum was asked for last, like the model
};

}  // namespace rubber_suspension::fit
