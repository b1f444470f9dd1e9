// Simulated force of logs as a function of a component's unknown parameters, in some of which it is linear, and least
// squares over the others.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "numerics/trust_region.h"
#include "rubber_suspension/fit/identification.h"

namespace rubber_suspension::fit {

/// Range in which a parameter is searched.
struct Reach {
  double lower;  ///< limits of the search
  double upper;
  double start_lower;  ///< where starts are spread
  double start_upper;
};

/// An unknown parameter, with its reach in search coordinates.
struct Unknown : Reach {
  std::size_t element;  ///< index into the elements
  std::string name;
  std::string unit;
  double given;
  bool logarithmic;  ///< the search runs over ln(value), else over value/scale
  double scale;      ///< 1 for logarithmic ones
  bool linear;       ///< scales a force; so does no fixed parameter of its element

  double toSearch(double value) const { return logarithmic ? std::log(value) : value / scale; }
  double toValue(double search) const { return logarithmic ? std::exp(search) : search * scale; }
};

/// Returns half of the largest range of displacement in a log [m].
double amplitudeOf(const std::vector<log::Log>& logs);

/// The samples whose force was measured.
struct Compared {
  std::vector<Eigen::Index> rows;  ///< among all samples
  std::vector<Eigen::Index> runs;  ///< lengths of stretches without time gaps; noise is independent between stretches
  Eigen::VectorXd force;           ///< [N]
};

/// The eliminated coefficients at some search coordinates.
struct ModelFit {
  Eigen::VectorXd search;
  Eigen::VectorXd coefficients;  ///< of the basis of the ForceModel
};

/// Force at the compared samples: unscaled(nonlinear) + basis(nonlinear) * coefficients. A coefficient of 1 stands for
/// the given value of a linear unknown. After the linear unknowns, the basis has a constant 1 for the force offset, and
/// the errors of the rig.
///
/// Least squares run over the nonlinear unknowns alone (variable projection): the sum of squares of measured minus
/// simulated force [N^2] has the best coefficients at each point. The slope omits a term of the Jacobian that is
/// orthogonal to the residual (L. Kaufman, BIT 15 (1975) 49-57), so the gradient is exact, and so is the optimum.
class ForceModel final : public numerics::SumOfSquares {
 public:
  /// The elements have to be complete. `held`: parameters as "type.name". `rig`: IdentificationOptions::rig. The logs
  /// and `compared` have to outlive the object.
  ForceModel(std::vector<element::ElementDescription> elements, const std::vector<log::Log>& logs,
             const Compared& compared, const std::vector<std::string>& held,
             const std::vector<Eigen::MatrixXd>& rig = {});

  const std::vector<Unknown>& nonlinear() const { return nonlinear_; }
  const std::vector<Unknown>& linear() const { return linear_; }
  const std::vector<element::ElementDescription>& elements() const { return elements_; }

  double at(const Eigen::VectorXd& search) override;
  Slope slope() override;
  double unit() const override { return unit_; }
  double rounding() const override { return 1e-21; }

  /// Returns the best coefficients at these search coordinates. Throws std::invalid_argument for values that a law does
  /// not accept together.
  ModelFit fitAt(const Eigen::VectorXd& search);
  /// Returns the residual of the last fit [N].
  auto residual() const { return columns_.col(1 + bases()); }
  /// Finds the derivatives of the force by the search coordinates of the last fit, by differences; only parts that
  /// depend on an unknown are simulated.
  void differentiate(const ModelFit& fit);
  /// Returns all columns: measured minus unscaled force, the basis, the residual, the derivatives.
  const Eigen::MatrixXd& columns() const { return columns_; }
  Eigen::MatrixXd takeColumns() { return std::move(columns_); }  ///< the object cannot be used afterwards
  /// Returns the part of the products of all columns that belongs to the derivatives by the search coordinates, then by
  /// relative changes of the coefficients, or by the coefficients themselves where they are 0.
  static Eigen::MatrixXd ofParameters(const ModelFit& fit, const Eigen::MatrixXd& products);

 private:
  // Elements that are simulated together, for one column of the basis or for the unscaled force.
  struct Part {
    std::vector<element::ElementDescription> elements;  // one, or all where they act on each other
    std::vector<Eigen::Index> unknowns;                 // nonlinear ones that it depends on
    Eigen::Index column = -1;                           // of the basis; -1: unscaled force
    Eigen::VectorXd values = {};                        // of its unknowns when last simulated
    bool simulated = false;
    Eigen::VectorXd force = {};  // unscaled force
  };
  using Force = Eigen::Ref<Eigen::VectorXd>;
  using Elements = std::vector<element::ElementDescription>;
  /// A simulation over all logs and the destination of its force.
  struct Simulation {
    Elements elements;
    double* force;
  };

  const Eigen::VectorXd& measured() const { return compared_.force; }
  Eigen::Index bases() const { return static_cast<Eigen::Index>(signed_columns_.size()); }
  Force forceOf(Part& part) { return part.column < 0 ? Force(part.force) : Force(columns_.col(1 + part.column)); }
  void addNonlinear(const Unknown& unknown, Part& part);
  void addElement(std::size_t position, const std::vector<Unknown>& unknowns);
  void makeColumns(const std::vector<Eigen::MatrixXd>& rig);
  Elements elementsAt(const Part& part, const Eigen::VectorXd& values) const;
  void simulate(const std::vector<Simulation>& simulations);
  void simulate(const Simulation& simulation);
  /// Simulates the parts whose unknowns have changed.
  void evaluate(const Eigen::VectorXd& search);

  std::vector<element::ElementDescription> elements_;
  const std::vector<log::Log>& logs_;
  const Compared& compared_;
  double unit_;  // [N^2], of the measured force
  std::vector<Unknown> nonlinear_;
  std::vector<Unknown> linear_;
  std::vector<bool> signed_columns_;  // for each column of the basis, whether its coefficient may be negative
  std::vector<Part> parts_;
  Eigen::MatrixXd columns_;   // columns()
  Eigen::VectorXd all_;       // force at all samples; empty if all are compared
  Eigen::MatrixXd moved_;     // forces at moved unknowns, of further parts that have the same unknown
  ModelFit last_;             // of the last call of at()
  Eigen::MatrixXd products_;  // of the basis at last_
  std::vector<double> dt_;    // of each log [s]; empty unless all logs have even steps and are compared throughout
};

}  // namespace rubber_suspension::fit
