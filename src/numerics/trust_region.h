// Nonlinear least squares over a few coordinates within limits: the search of fits to logs and to tables.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace rubber_suspension::numerics {

/// A sum of squared residuals as a function of some coordinates.
class SumOfSquares {
 public:
  /// J'r and J'J for the residuals r with Jacobian J; not finite if there are no derivatives.
  struct Slope {
    Eigen::VectorXd gradient;
    Eigen::MatrixXd curvature;
  };

  virtual ~SumOfSquares() = default;

  /// Returns the sum at these coordinates; not finite if the residuals have no value there.
  virtual double at(const Eigen::VectorXd& x) = 0;
  /// Returns the slope at the coordinates of the last call of at().
  virtual Slope slope() = 0;
  /// Returns a value much larger than the sum of a good fit, for example the sum of squares of the measured values.
  virtual double unit() const = 0;
  /// Returns the rounding error of the sum relative to unit().
  virtual double rounding() const = 0;
};

/// Sum of squares of residuals, with a Jacobian by central differences. It is not finite where the residuals throw
/// std::invalid_argument.
class DifferencedSquares final : public SumOfSquares {
 public:
  using Residuals = std::function<Eigen::VectorXd(const Eigen::VectorXd& x)>;

  /// `step`: step of each coordinate. The residuals of a good fit have to be small compared with 1.
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

struct SearchTolerances {
  int most_steps = 60;
  double cost = 1e-10;  ///< relative change of the sum
  double step = 1e-9;   ///< change of the coordinates relative to their length
};

struct Optimum {
  Eigen::VectorXd search;
  double cost = 0.0;  ///< not finite if the search could not begin
};

/// Minimises by Levenberg-Marquardt steps (J. J. More, Lect. Notes Math. 630 (1978) 105-116) within the limits. Ends
/// when `tolerances` are met, or when the predicted reduction is below the rounding of the sum.
Optimum searchLeast(SumOfSquares& sum, const Eigen::VectorXd& start, const Limits& limits,
                    const SearchTolerances& tolerances = {});

}  // namespace rubber_suspension::numerics
