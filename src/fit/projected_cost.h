// The cost that is left once the linear unknowns have taken their best values, from products of columns alone.
#pragma once

#include <vector>

#include "fit/force_model.h"
#include "fit/unit_columns.h"

namespace rubber_suspension::fit {

/// Variable projection (see ForceModel) without the residuals: coefficients, cost and its derivatives all follow from
/// the products of UnitColumns. Since that squares the condition of the columns, the cost has a rounding of about
/// UnitColumns::rounding() of the force's sum of squares, however small it is itself.
class ProjectedCost {
 public:
  struct Value {
    Eigen::VectorXd coefficients;  ///< of the basis of the ForceModel
    double cost = 0.0;             ///< sum of squared residuals [N^2]
    Eigen::VectorXd gradient;      ///< of half the cost by the search coordinates
    Eigen::MatrixXd curvature;     ///< J'J, J as in L. Kaufman, BIT 15 (1975) 49-57
  };

  /// True for springs, dashpots, Maxwell elements and Berg friction over logs with few step lengths, if there is
  /// anything to search for.
  static bool appliesTo(const ForceModel& model, const std::vector<log::Log>& logs);

  /// For a model that it applies to.
  ProjectedCost(const ForceModel& model, const std::vector<log::Log>& logs);

  Value at(const Eigen::VectorXd& search);

  /// At some search coordinates and coefficients: measured less simulated force [N], and the Jacobian of FitMethod,
  /// with its products.
  Eigen::VectorXd residual(const Eigen::VectorXd& search, const Eigen::VectorXd& coefficients) const;
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& search, const Eigen::VectorXd& coefficients) const;
  Eigen::MatrixXd jacobianProducts(const Eigen::VectorXd& search, const Eigen::VectorXd& coefficients);

  /// Sum of squares of the measured force [N^2].
  double unit() const { return unit_; }

 private:
  // A law with a parameter that it is not linear in: a Maxwell element or friction.
  struct Law {
    double given;          // of that parameter
    Eigen::Index unknown;  // among the search coordinates; -1: held
  };

  static constexpr Eigen::Index kNone = -1;

  void addElement(const ForceModel& model, std::size_t position);
  Eigen::Index addColumn(const ForceModel& model, std::size_t position, Eigen::Index unit, double scale);
  UnitColumnValues valuesAt(const Eigen::VectorXd& search) const;
  const Eigen::MatrixXd& productsAt(const Eigen::VectorXd& search);
  Eigen::VectorXd scales(const Eigen::VectorXd& coefficients) const;
  Eigen::MatrixXd jacobianCombination(const Eigen::VectorXd& coefficients) const;
  Eigen::MatrixXd takenByBasis(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& shared,
                               const Eigen::VectorXd& coefficients) const;

  UnitColumns columns_;
  double unit_ = 0.0;
  std::vector<Law> maxwells_;
  std::vector<Law> frictions_;
  std::vector<bool> signed_columns_;
  std::vector<Eigen::Index> owner_;  // of each search coordinate: the column of the basis; kNone: its coefficient is 1
  // The model in unit columns: measured force less what is held, basis, derivatives of the basis' columns by the search
  // coordinates.
  Eigen::MatrixXd combination_;
  Eigen::VectorXd last_search_;  // where the products were formed last
  Eigen::MatrixXd last_products_;
};

}  // namespace rubber_suspension::fit
