// Fit by products of columns: a pass of the logs for each step of the search, and a handful of numbers.
#pragma once

#include "fit/fit_method.h"
#include "fit/projected_cost.h"

namespace rubber_suspension::fit {

/// Variable projection by ProjectedCost. The search takes the steps of Levenberg and Marquardt (J. J. More, Lect. Notes
/// Math. 630 (1978) 105-116), damped as Ceres does it, over those coordinates that no limit holds. It ends with the
/// tolerances of ResidualFit, or where a step promises less than the rounding of the cost.
class ProductFit final : public FitMethod {
 public:
  /// Whether it can fit this; see ProjectedCost.
  static bool appliesTo(const ForceModel& model, const std::vector<log::Log>& logs) {
    return ProjectedCost::appliesTo(model, logs);
  }

  ProductFit(const ForceModel& model, const std::vector<log::Log>& logs);

  Optimum search(const Eigen::VectorXd& start) override;
  ModelFit fitAt(const Eigen::VectorXd& search) override;
  Eigen::MatrixXd jacobian(const ModelFit& fit) override;
  Eigen::MatrixXd jacobianProducts(const ModelFit& fit) override;
  double rounding() const override { return 10.0 * UnitColumns::rounding(); }

 private:
  Eigen::VectorXd inside(const Eigen::VectorXd& x) const { return x.cwiseMax(lower_).cwiseMin(upper_); }
  Eigen::VectorXd stepFrom(const Eigen::VectorXd& x, const ProjectedCost::Value& here, double radius) const;

  ProjectedCost cost_;
  Eigen::VectorXd lower_;  // limits of the search coordinates
  Eigen::VectorXd upper_;
};

}  // namespace rubber_suspension::fit
