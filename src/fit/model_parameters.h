// The parameters that a model already has, as unknowns of a fit.
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

/// The numbers that a fit varies.
enum class Level {
  specification,  ///< numbers of the user: K_st, K_n, K_max, f_h, ...; for a list of elements, all their parameters
  elements,       ///< those of the estimated elements: every stiffness, every break frequency
};

/// A number that is known before any measurement.
struct KnownNumber {
  std::string name;  ///< a key of the specification, or of a parameter of an element
  double logarithm;  ///< of the known value
  double deviation;  ///< standard deviation of the logarithm
  bool of_sheet;     ///< else of a single element
  bool of_base;      ///< of the sheet or the listed elements, not of an added element
};

/// Parameters of a model as logarithms of their ratios to the configured values, so that 0 is "as configured".
///
/// Most combinations of the stiffnesses of a specification have no model. The models of springs, dashpots and Maxwell
/// elements are therefore varied in coordinates in which every point has one (static stiffness, relaxing stiffness
/// K_max - K_st, ratio alpha of neighbouring elements, frequencies, damping); the specification follows from them.
/// Other models are varied in the numbers of their specification. The point of operation (nominal frequency and
/// amplitude) and counts are fixed.
class ModelParameters {
 public:
  ModelParameters(const io::ComponentDescription& description, Level level);

  Eigen::Index size() const { return static_cast<Eigen::Index>(names_.size()); }
  const std::vector<std::string>& names() const { return names_; }

  /// Bounds on |logarithm| of the parameters: a factor of 3 for specified numbers, beyond which it is another
  /// component, and 10 for values of single elements, which can replace each other, or two standard deviations if that
  /// is more; 100 for alpha, relaxing stiffness, break frequency and damping, which sheets do not state directly.
  const Eigen::VectorXd& bounds() const { return bounds_; }

  /// Returns the largest ratio by which a number of the sheet may be wrong: two standard deviations of the least
  /// certain one, but at least 3.
  double largestRatio() const;

  /// Returns the numbers that are known beforehand: those of the sheet, then values of single elements.
  const std::vector<KnownNumber>& known() const { return known_; }

  /// Returns the deviation of each known number in standard deviations of its logarithm; the squares add up to chi^2.
  /// Defined for any point, even one without a component.
  Eigen::VectorXd departures(const Eigen::VectorXd& logarithms) const;

  /// Returns the derivatives of departures() by the logarithms, a row for each known number.
  Eigen::MatrixXd departureSlopes(const Eigen::VectorXd& logarithms) const;

  /// Returns starts of fits: as configured, with the Maxwell stiffness concentrated at either end of its band, and with
  /// a usual relaxing stiffness if that of the sheet is nearly 0.
  std::vector<Eigen::VectorXd> starts() const;

  /// Returns true if only the order of magnitude is known of all numbers of the sheet, or of all listed elements.
  bool isGuess() const;

  /// Returns the configured value of a parameter of an element, at the level of elements [SI].
  double configured(Eigen::Index parameter) const { return slots_[static_cast<std::size_t>(parameter)].configured; }

  /// Returns the component with these logarithms of ratios. Throws std::invalid_argument if there is none.
  io::ComponentDescription apply(const Eigen::VectorXd& logarithms) const;

  /// Returns its elements; nullopt if the specification has no solution or an element rejects its parameters.
  std::optional<std::vector<element::ElementDescription>> elements(const Eigen::VectorXd& logarithms) const;

  /// Returns the changes that the user would have to write: new over old value of every number of the specification, or
  /// of every parameter of the elements, that differs. Defined for any point, even one without a component, as may
  /// result from a fit to a single log.
  std::vector<std::pair<std::string, double>> ratios(const Eigen::VectorXd& logarithms) const;

 private:
  /// Coordinates of the models M2, M3 and multi-Maxwell in which every point has a model.
  struct Relaxation {
    double static_stiffness = 0.0;
    double relaxing_stiffness = 0.0;  // sum of the Maxwell stiffnesses
    double alpha = 1.0;               // k_i/k_(i+1)
    double break_frequency = 0.0;     // of the fastest element
    double band_ratio = 1.0;          // q, of neighbouring break frequencies
    double damping = 0.0;             // of the dashpot
    std::size_t elements = 0;

    double highFrequency() const { return 2.0 * break_frequency / (1.0 + 1.0 / band_ratio); }
    double lowFrequency() const { return highFrequency() / std::pow(band_ratio, static_cast<double>(elements)); }
    std::complex<double> stiffnessAt(double frequency) const;
  };

  /// The numbers of a point.
  struct Point {
    estimation::Specification specification;
    Relaxation relaxation;
    std::vector<element::ElementDescription> elements;
    std::vector<element::ElementDescription> added;
  };

  struct Slot {
    std::function<void(Point& point, double ratio)> move;
    bool of_element;    // else of the specification
    double configured;  // of an element: the value, given or by default
    double deviation;   // of its logarithm, of an element
  };

  void addRelaxation();
  void addSpecification();
  void addElements(std::vector<element::ElementDescription> Point::* list);
  void add(const std::string& name, Slot slot, double largest_ratio);
  void addKnown(std::size_t of_base);
  /// Returns a number of the sheet, whether or not a component has the numbers of the point.
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
