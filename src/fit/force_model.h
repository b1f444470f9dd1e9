// The simulated force of a log as a function of a component's unknown parameters, those that scale a force set apart,
// and least squares over the others.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "numerics/trust_region.h"
#include "rubber_suspension/fit/identification.h"

namespace rubber_suspension::fit {

/// Where a parameter is searched.
struct Reach {
  double lower;  ///< limits of the search
  double upper;
  double start_lower;  ///< where starts are spread
  double start_upper;
};

/// A parameter that is sought, and its reach in search coordinates.
struct Unknown : Reach {
  std::size_t element;  ///< index into the elements
  std::string name;
  std::string unit;
  double given;
  bool logarithmic;  ///< the search runs over ln(value), else over value/scale
  double scale;      ///< 1 for logarithmic ones
  bool linear;       ///< scales a force, as all such parameters of its element, which are all sought

  double toSearch(double value) const { return logarithmic ? std::log(value) : value / scale; }
  double toValue(double search) const { return logarithmic ? std::exp(search) : search * scale; }
};

/// Largest displacement from the middle of its log [m].
double amplitudeOf(const std::vector<log::Log>& logs);

/// The samples of some logs whose force was measured.
struct Compared {
  std::vector<Eigen::Index> rows;  ///< among all samples
  std::vector<Eigen::Index> runs;  ///< how many follow one another: noise is independent of that before a time gap
  Eigen::VectorXd force;           ///< [N]
};

/// The eliminated coefficients at some search coordinates.
struct ModelFit {
  Eigen::VectorXd search;
  Eigen::VectorXd coefficients;  ///< of the basis of the ForceModel
};

/// force = rest(nonlinear) + basis(nonlinear) * coefficients, at the samples that are compared. A coefficient of 1 is
/// the linear unknown as given; after the linear unknowns, the basis has the constant 1, the force offset, and what
/// else the rig may have added.
///
/// Least squares run over the nonlinear unknowns alone (variable projection): the sum is of measured less simulated
/// force [N^2], by the search coordinates, with the best coefficients for each. Its slope leaves out a term that is
/// across the residual (L. Kaufman, BIT 15 (1975) 49-57), so the gradient is exact, and so is the optimum.
class ForceModel final : public numerics::SumOfSquares {
 public:
  /// The elements have to be complete, `held` to name parameters as "type.name".
  /// `rig`: of each log, as IdentificationOptions::rig. All but the elements have to outlive it.
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

  /// The best coefficients at these search coordinates. Throws std::invalid_argument for values that a law does not
  /// accept together.
  ModelFit fitAt(const Eigen::VectorXd& search);
  /// The part of the measured force that the last fit leaves.
  auto residual() const { return columns_.col(1 + bases()); }
  /// Find the derivatives of the force by the search coordinates of the last fit, by differences; only what depends on
  /// an unknown is simulated.
  void differentiate(const ModelFit& fit);
  /// All columns: the rest of the measured force, the basis, the residual, the derivatives.
  const Eigen::MatrixXd& columns() const { return columns_; }
  Eigen::MatrixXd takeColumns() { return std::move(columns_); }  ///< nothing is left to be asked for
  /// By products of all columns those of the derivatives of the force by the search coordinates, then by relative
  /// changes of the coefficients, or by the coefficients themselves where they are zero.
  static Eigen::MatrixXd ofParameters(const ModelFit& fit, const Eigen::MatrixXd& products);

 private:
  // Elements that are simulated together, for one column or as a share of the rest.
  struct Part {
    std::vector<element::ElementDescription> elements;  // one, or all where they act on each other
    std::vector<Eigen::Index> unknowns;                 // nonlinear ones that it depends on
    Eigen::Index column = -1;                           // of the basis; -1: rest
    Eigen::VectorXd values = {};                        // of its unknowns when last simulated
    bool simulated = false;
    Eigen::VectorXd force = {};  // of the rest
  };
  using Force = Eigen::Ref<Eigen::VectorXd>;
  using Elements = std::vector<element::ElementDescription>;
  /// A simulation over all logs, and where its force goes.
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
  /// Parts whose unknowns did not change are not simulated again.
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
  Eigen::VectorXd all_;       // force at all samples; none where all are compared
  Eigen::MatrixXd moved_;     // moved forces of parts with an unknown that another part has, too
  ModelFit last_;             // of the sum that was asked for last
  Eigen::MatrixXd products_;  // of the basis there
  std::vector<double> dt_;    // of each log [s]; empty where not all have even steps or are compared throughout
};

}  // namespace rubber_suspension::fit
