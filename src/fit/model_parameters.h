// The parameters that a model already has, as parameters of a fit.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::fit {

/// The kind of numbers that a fit varies.
enum class Level {
  specification,  ///< numbers of the user, such as the static stiffness; for a list of elements, all their parameters
  elements,       ///< numbers of the estimated elements: every stiffness, every break frequency
};

/// A number that is known before any measurement.
struct KnownNumber {
  std::string name;  ///< key of the specification, or of a parameter of an element
  double logarithm;  ///< logarithm of the known value
  double deviation;  ///< standard deviation of the logarithm
  bool of_sheet;     ///< true for a number of the data sheet, false for a parameter of an element
  bool of_base;      ///< true for the data sheet or the listed elements, false for an added element
};

/// Parameters of a model as logarithms of their ratios to the configured values. At 0 all values are as configured.
///
/// Most combinations of the stiffnesses of a specification have no model. Models of springs, dashpots and Maxwell
/// elements are therefore varied in coordinates in which every point has a model: static stiffness, relaxing stiffness
/// K_max - K_st, ratio alpha of the stiffnesses of neighbouring elements, frequencies, damping. The specification
/// follows from these. Other models are varied in the numbers of their specification. Nominal frequency and amplitude,
/// and counts, are fixed.
class ModelParameters {
 public:
  ModelParameters(const io::ComponentDescription& description, Level level);

  Eigen::Index size() const { return static_cast<Eigen::Index>(names_.size()); }
  const std::vector<std::string>& names() const { return names_; }

  /// Returns bounds on |logarithm| of the parameters. Numbers of the specification vary by a factor of 3, values of
  /// elements, which can replace each other, by 10, or both by two standard deviations if that is more. Numbers that no
  /// data sheet states directly (alpha, relaxing stiffness, break frequency, damping) vary by at least 100.
  const Eigen::VectorXd& bounds() const { return bounds_; }

  /// Returns the largest factor by which a number of the data sheet may be wrong: two standard deviations of the least
  /// certain number, but at least 3.
  double largestRatio() const;

  /// Returns the numbers that are known beforehand: first those of the data sheet, then parameters of single elements.
  const std::vector<KnownNumber>& known() const { return known_; }

  /// Returns the departure of each known number from its known value, in standard deviations of the logarithm. The
  /// squares add up to chi^2. Also defined for points without a component.
  Eigen::VectorXd departures(const Eigen::VectorXd& logarithms) const;

  /// Returns the derivatives of departures() with respect to the logarithms; each row belongs to a known number.
  Eigen::MatrixXd departureSlopes(const Eigen::VectorXd& logarithms) const;

  /// Returns starting points of fits: as configured, with the Maxwell stiffness concentrated at either end of its
  /// frequency band, and with a usual relaxing stiffness if the data sheet implies nearly 0.
  std::vector<Eigen::VectorXd> starts() const;

  /// Returns true if all numbers of the data sheet, or all listed elements, are known only to an order of magnitude.
  bool isGuess() const;

  /// Returns the configured value [SI] of a parameter of an element, at Level::elements.
  double configured(Eigen::Index parameter) const { return slots_[static_cast<std::size_t>(parameter)].configured; }

  /// Returns the component for these logarithms of ratios. Throws std::invalid_argument if there is none.
  io::ComponentDescription apply(const Eigen::VectorXd& logarithms) const;

  /// Returns the elements of this component; nullopt if there is no solution or an element rejects its parameters.
  std::optional<std::vector<element::ElementDescription>> elements(const Eigen::VectorXd& logarithms) const;

  /// Returns the changes that the user would have to write: the ratio of new to old value for every number that differs
  /// in the specification or the elements. Also defined for points without a component, which may result from a fit to
  /// a single log.
  std::vector<std::pair<std::string, double>> ratios(const Eigen::VectorXd& logarithms) const;

 private:
  /// Coordinates of the models M2, M3 and multi-Maxwell in which every point has a model.
  struct Relaxation {
    double static_stiffness = 0.0;
    double relaxing_stiffness = 0.0;  // sum of the stiffnesses of the Maxwell elements
    double alpha = 1.0;               // ratio k_i/k_(i+1) of the stiffnesses of neighbouring elements
    double break_frequency = 0.0;     // break frequency of the fastest element
    double band_ratio = 1.0;          // ratio q of neighbouring break frequencies
    double damping = 0.0;             // coefficient of the dashpot
    std::size_t elements = 0;

    double highFrequency() const { return 2.0 * break_frequency / (1.0 + 1.0 / band_ratio); }
    double lowFrequency() const { return highFrequency() / std::pow(band_ratio, static_cast<double>(elements)); }
    std::complex<double> stiffnessAt(double frequency) const;
  };

  /// The values of all numbers at a point of the fit.
  struct Point {
    estimation::Specification specification;
    Relaxation relaxation;
    std::vector<element::ElementDescription> elements;
    std::vector<element::ElementDescription> added;
  };

  struct Slot {
    std::function<void(Point& point, double ratio)> move;
    bool of_element;    // true for a parameter of an element, false for a number of the specification
    double configured;  // value of the element's parameter, given or by default
    double deviation;   // standard deviation of the logarithm of the element's parameter
  };

  void addRelaxation();
  void addSpecification();
  void addElements(std::vector<element::ElementDescription> Point::* list);
  void add(const std::string& name, Slot slot, double largest_ratio);
  void addKnown(std::size_t of_base);
  /// Returns a number of the data sheet, whether or not a component with the numbers of the point exists.
  double sheetNumber(const Point& point, const std::string& key) const;
  Point movedBy(const Eigen::VectorXd& logarithms) const;
  /// Returns the point with its specification.
  Point pointAt(const Eigen::VectorXd& logarithms) const;
  void specify(Point& point) const;
  double sheetDeviation(const std::string& key) const { return configured_.specification.tolerance().of(key); }

  io::ComponentDescription description_;
  Point configured_;
  std::vector<Slot> slots_;
  std::vector<std::string> names_;
  Eigen::VectorXd bounds_;
  std::vector<KnownNumber> known_;
};

}  // namespace rubber_suspension::fit
