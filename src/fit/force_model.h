// Simulated force of logs as a function of a component's unknown parameters. It is linear in some of them; the others
// are found by nonlinear least squares.
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
  double lower;  ///< lower and upper limit of the search
  double upper;
  double start_lower;  ///< range of the random starts
  double start_upper;
};

/// An unknown parameter, with its range in search coordinates.
struct Unknown : Reach {
  std::size_t element;  ///< index of the parameter's element
  std::string name;
  std::string unit;
  double given;
  bool logarithmic;  ///< the search coordinate is ln(value) if true, value/scale if false
  double scale;      ///< 1 if the search coordinate is logarithmic
  bool linear;       ///< true if it scales a force and no fixed parameter of its element does so

  double toSearch(double value) const { return logarithmic ? std::log(value) : value / scale; }
  double toValue(double search) const { return logarithmic ? std::exp(search) : search * scale; }
};

/// Returns half of the largest range of displacement in a log [m].
double amplitudeOf(const std::vector<log::Log>& logs);

/// The samples at which measured and simulated force are compared.
struct Compared {
  std::vector<Eigen::Index> rows;  ///< indices of the compared samples among all samples
  std::vector<Eigen::Index> runs;  ///< lengths of runs without time gaps; the noise of different runs is independent
  Eigen::VectorXd force;           ///< [N]
};

/// The coefficients of the basis that are optimal at some search coordinates.
struct ModelFit {
  Eigen::VectorXd search;
  Eigen::VectorXd coefficients;  ///< one coefficient for each column of the basis of the ForceModel
};

/// Force at the compared samples: unscaled(nonlinear) + basis(nonlinear) * coefficients. The first columns of the basis
/// belong to the linear parameters, whose given values have the coefficient 1. Then follow a constant 1 for the force
/// offset, and the errors of the rig.
///
/// The search varies only the nonlinear parameters (variable projection). At each point the sum of squares of measured
/// minus simulated force [N^2] is computed with the optimal coefficients. The slope omits a term of the Jacobian that
/// is orthogonal to the residual (L. Kaufman, BIT 15 (1975) 49-57), so that gradient and optimum are exact.
class ForceModel final : public numerics::SumOfSquares {
 public:
  /// The elements have to be complete. `held`: fixed parameters as "type.name". `rig`: see IdentificationOptions. The
  /// logs and `compared` have to outlive the object.
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

  /// Returns the optimal coefficients at these search coordinates. Throws std::invalid_argument if a law rejects the
  /// values.
  ModelFit fitAt(const Eigen::VectorXd& search);
  /// Returns the residual of the last fit [N].
  auto residual() const { return columns_.col(1 + bases()); }
  /// Computes the derivatives of the force with respect to the search coordinates of the last fit, by differences. Only
  /// parts that depend on a parameter are simulated.
  void differentiate(const ModelFit& fit);
  /// Returns all columns: measured minus unscaled force, the basis, the residual, and the derivatives.
  const Eigen::MatrixXd& columns() const { return columns_; }
  Eigen::MatrixXd takeColumns() { return std::move(columns_); }  ///< the object cannot be used afterwards
  /// Returns the part of the `products` of all columns that belongs to the parameters: derivatives with respect to
  /// search coordinates, then to relative changes of the coefficients (absolute changes where a coefficient is 0).
  static Eigen::MatrixXd ofParameters(const ModelFit& fit, const Eigen::MatrixXd& products);

 private:
  // Elements that are simulated together, for one column of the basis or for the unscaled force.
  struct Part {
    std::vector<element::ElementDescription> elements;  // one element, or all elements if they affect each other
    std::vector<Eigen::Index> unknowns;                 // nonlinear parameters on which the part depends
    Eigen::Index column = -1;                           // index in the basis; -1 for the unscaled force
    Eigen::VectorXd values = {};                        // values of the parameters when the part was last simulated
    bool simulated = false;
    Eigen::VectorXd force = {};  // force of the unscaled elements
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
  /// Simulates the parts whose parameters have changed.
  void evaluate(const Eigen::VectorXd& search);

  std::vector<element::ElementDescription> elements_;
  const std::vector<log::Log>& logs_;
  const Compared& compared_;
  double unit_;  // sum of squares of the measured force [N^2]
  std::vector<Unknown> nonlinear_;
  std::vector<Unknown> linear_;
  std::vector<bool> signed_columns_;  // for each column of the basis, true if its coefficient may be negative
  std::vector<Part> parts_;
  Eigen::MatrixXd columns_;   // see columns()
  Eigen::VectorXd all_;       // force at all samples; empty if all are compared
  Eigen::MatrixXd moved_;     // forces at a varied parameter, for all further parts that depend on it
  ModelFit last_;             // result of the last call of at()
  Eigen::MatrixXd products_;  // products of the basis at last_
  std::vector<double> dt_;    // time step of each log [s]; empty unless all have even steps and are compared throughout
};

}  // namespace rubber_suspension::fit
