// Fit by products of columns: a pass of the logs for each step of the search, and a handful of numbers.
#pragma once

#include <vector>

#include "fit/fit_method.h"
#include "fit/force_model.h"
#include "fit/unit_columns.h"

namespace rubber_suspension::fit {

/// Variable projection without the residuals: coefficients, sum of squares and slope all follow from the products of
/// UnitColumns. Since that squares the condition of the columns, the sum has a rounding of about
/// UnitColumns::rounding() of the force's sum of squares, however small it is itself.
class ProductFit final : public FitMethod {
 public:
  /// True for springs, dashpots, Maxwell elements and Berg friction over logs with few step lengths, if there is
  /// anything to search for.
  static bool appliesTo(const ForceModel& model, const std::vector<log::Log>& logs);

  /// For a model that it applies to.
  ProductFit(const ForceModel& model, const std::vector<log::Log>& logs);

  double at(const Eigen::VectorXd& search) override { return valueAt(search).cost; }
  Slope slope() override;
  double unit() const override { return unit_; }
  double rounding() const override { return UnitColumns::rounding(); }

  ModelFit fitAt(const Eigen::VectorXd& search) override;
  Eigen::MatrixXd jacobian(const ModelFit& fit) override;
  Eigen::MatrixXd jacobianProducts(const ModelFit& fit) override;

 private:
  // A law with a parameter that it is not linear in: a Maxwell element or friction.
  struct Law {
    double given;          // of that parameter
    Eigen::Index unknown;  // among the search coordinates; -1: held
  };

  struct Value {
    Eigen::VectorXd coefficients;  // of the basis of the ForceModel
    double cost = 0.0;
  };

  static constexpr Eigen::Index kNone = -1;

  void addElement(const ForceModel& model, std::size_t position);
  Eigen::Index addColumn(const ForceModel& model, std::size_t position, Eigen::Index unit, double scale);
  UnitColumnValues valuesAt(const Eigen::VectorXd& search) const;
  const Eigen::MatrixXd& productsAt(const Eigen::VectorXd& search);
  const Value& valueAt(const Eigen::VectorXd& search);
  Eigen::VectorXd scales(const Eigen::VectorXd& coefficients) const;
  Eigen::MatrixXd jacobianCombination(const Eigen::VectorXd& coefficients) const;
  Eigen::MatrixXd takenByBasis(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& shared,
                               const Eigen::VectorXd& coefficients) const;

  UnitColumns columns_;
  double unit_ = 0.0;  // sum of squares of the measured force [N^2]
  std::vector<Law> maxwells_;
  std::vector<Law> frictions_;
  std::vector<bool> signed_columns_;
  std::vector<Eigen::Index> owner_;  // of each search coordinate: the column of the basis; kNone: its coefficient is 1
  // The model in unit columns: measured force less what is held, basis, derivatives of the basis' columns by the search
  // coordinates.
  Eigen::MatrixXd combination_;
  Eigen::VectorXd last_search_;  // where the products of UnitColumns were formed last
  Eigen::MatrixXd last_products_;
  Eigen::MatrixXd products_;  // of the model there
  Value value_;
};

}  // namespace rubber_suspension::fit
