// Least squares over a few coordinates within limits: the search of the fits to logs and to tables.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace rubber_suspension::numerics {

/// A sum of squared residuals over some coordinates.
class SumOfSquares {
 public:
  /// J'r and J'J of the residuals r and their Jacobian J; not finite where there are no derivatives.
  struct Slope {
    Eigen::VectorXd gradient;
    Eigen::MatrixXd curvature;
  };

  virtual ~SumOfSquares() = default;

  /// The sum at these coordinates; not finite where there is none.
  virtual double at(const Eigen::VectorXd& x) = 0;
  /// At the coordinates that at() was asked for last.
  virtual Slope slope() = 0;
  /// A size that the sum is small against, such as the sum of squares of what was measured.
  virtual double unit() const = 0;
  /// Rounding of the sum, relative to unit().
  virtual double rounding() const = 0;
};

/// Sum of squares of residuals with a Jacobian by central differences. Where they throw std::invalid_argument, it has
/// no value.
class DifferencedSquares final : public SumOfSquares {
 public:
  using Residuals = std::function<Eigen::VectorXd(const Eigen::VectorXd& x)>;

  /// `step`: of each coordinate. The residuals are in units that a good fit is small against.
  DifferencedSquares(Residuals residuals, double step) : residuals_(std::move(residuals)), step_(step) {}

  double at(const Eigen::VectorXd& x) override;
  Slope slope() override;
  double unit() const override { return 1.0; }
  double rounding() const override { return 1e-18; }

  Eigen::MatrixXd jacobian(const Eigen::VectorXd& x) const;

 private:
  Residuals residuals_;
  double step_;
  Eigen::VectorXd last_;
};

struct Limits {
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;

  Eigen::VectorXd inside(const Eigen::VectorXd& x) const { return x.cwiseMax(lower).cwiseMin(upper); }
};

/// Convergence criteria of a search.
struct SearchTolerances {
  int most_steps = 60;
  double cost = 1e-10;  ///< relative change
  double step = 1e-9;   ///< of the coordinates, relative to their length
};

/// Where a search ended.
struct Optimum {
  Eigen::VectorXd search;
  double cost = 0.0;  ///< not finite where the search could not begin
};

/// Steps of Levenberg and Marquardt (J. J. More, Lect. Notes Math. 630 (1978) 105-116) over those coordinates that no
/// limit holds. The search ends with the tolerances, or where a step promises less than the rounding of the sum.
Optimum searchLeast(SumOfSquares& sum, const Eigen::VectorXd& start, const Limits& limits,
                    const SearchTolerances& tolerances = {});

}  // namespace rubber_suspension::numerics
