// The simulated force of a log as a function of a component's unknown parameters, those that scale a force set apart.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

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

/// force = rest(nonlinear) + basis(nonlinear) * coefficients. A coefficient of 1 is the linear unknown as given; after
/// the linear unknowns, the basis has the constant 1, the force offset, and what else the rig may have added.
class ForceModel {
 public:
  /// The elements have to be complete, `held` to name parameters as "type.name".
  /// `rig`: of each log, as IdentificationOptions::rig.
  ForceModel(std::vector<element::ElementDescription> elements, const std::vector<log::Log>& logs,
             const std::vector<std::string>& held, const std::vector<Eigen::MatrixXd>& rig = {});

  const std::vector<Unknown>& nonlinear() const { return nonlinear_; }
  const std::vector<Unknown>& linear() const { return linear_; }
  /// For each column of the basis, whether its coefficient may be negative.
  const std::vector<bool>& signedColumns() const { return signed_columns_; }
  const std::vector<element::ElementDescription>& elements() const { return elements_; }
  Eigen::Index size() const { return size_; }

  /// Simulate for these values in search coordinates; parts whose unknowns did not change are not simulated again.
  void evaluate(const Eigen::VectorXd& search);
  /// Derivative of the force by one of the search coordinates where it was evaluated last, for these coefficients of
  /// the basis, by differences; only what depends on that unknown is simulated.
  Eigen::VectorXd derivative(const Eigen::VectorXd& search, Eigen::Index unknown,
                             const Eigen::VectorXd& coefficients) const;
  const Eigen::MatrixXd& basis() const { return basis_; }
  const Eigen::VectorXd& rest() const { return rest_; }

 private:
  // Elements that are simulated together, for one column or as a share of the rest.
  struct Part {
    std::vector<element::ElementDescription> elements;  // one, or all where they act on each other
    std::vector<Eigen::Index> unknowns;                 // nonlinear ones that it depends on
    Eigen::Index column = -1;                           // -1: rest
    Eigen::VectorXd values;                             // of its unknowns when last simulated
    Eigen::VectorXd force;
  };

  void addNonlinear(const Unknown& unknown, Part& part);
  void addElement(std::size_t position, const std::vector<Unknown>& unknowns);
  void addRig(const std::vector<Eigen::MatrixXd>& rig);
  Eigen::VectorXd simulate(const Part& part, const Eigen::VectorXd& values) const;

  std::vector<element::ElementDescription> elements_;
  const std::vector<log::Log>& logs_;
  Eigen::Index size_ = 0;
  std::vector<Unknown> nonlinear_;
  std::vector<Unknown> linear_;
  std::vector<bool> signed_columns_;
  std::vector<Part> parts_;
  Eigen::MatrixXd basis_;
  Eigen::VectorXd rest_;
};

}  // namespace rubber_suspension::fit
