// From a data sheet to the elements of a model: specification, models, estimation.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/estimation/static_curve.h"

namespace rubber_suspension::estimation {

/// The models of a component file, in the order of the paper.
enum class Model {
  kelvin_voigt,      ///< M1
  maxwell,           ///< M2 with one element
  maxwell_dashpot,   ///< M3
  friction,          ///< M4
  friction_dashpot,  ///< M5
  berg,              ///< M6
  multi_maxwell,     ///< M2 with n_M elements
  elements,          ///< a list of elements, nothing to estimate
};

/// Returns the name in a component file.
std::string toString(Model model);

/// Returns the model of that name, or nullopt.
std::optional<Model> modelFromString(const std::string& name);

/// A unit as the user wrote it.
struct WrittenUnit {
  std::string name;  ///< "kN/mm"
  double size;       ///< in the SI unit, such as 1e6 N/m
};

/// Part of a component that its specification describes.
enum class Describes {
  unsaid,     ///< the base, with a note if elements are added
  base,       ///< the elements of the model alone
  component,  ///< the whole, with the elements that are added
};

/// Returns the name in a component file; "" for unsaid.
std::string toString(Describes describes);

/// One measured point of a component, for a fit.
struct SpecifiedPoint {
  double frequency = 0.0;            ///< [Hz]
  double amplitude = 0.0;            ///< [m]; 0: not given
  std::optional<double> stiffness;   ///< [N/m]
  std::optional<double> loss_angle;  ///< [rad]
  double weight = 1.0;
};

/// Tolerances of the numbers of a data sheet, as standard deviations of their logarithms.
struct SheetTolerance {
  static constexpr double kUsual = 0.1;                ///< if none is given
  static constexpr double kGuess = 2.302585092994046;  ///< ln 10: a guess

  std::optional<double> of_all = {};
  std::map<std::string, double, std::less<>> by_key = {};  ///< has precedence

  bool given() const { return of_all || !by_key.empty(); }
  double of(std::string_view key) const {
    const auto found = by_key.find(key);
    return found != by_key.end() ? found->second : of_all.value_or(kUsual);
  }
};

/// Numbers by the names of specificationParameters() [SI], loss angles in rad, and optionally a static curve or points.
class Specification {
 public:
  using Values = std::map<std::string, double, std::less<>>;
  using Units = std::map<std::string, WrittenUnit, std::less<>>;

  bool has(std::string_view name) const { return position(name) != values_.end(); }
  std::optional<double> find(std::string_view name) const {
    const auto found = position(name);
    return found == values_.end() ? std::nullopt : std::optional<double>(found->second);
  }
  /// Throws std::out_of_range if it is missing.
  double at(std::string_view name) const {
    const auto found = position(name);
    return found != values_.end() ? found->second : throw std::out_of_range(std::string(name));
  }
  double valueOr(std::string_view name, double fallback) const { return find(name).value_or(fallback); }
  void set(const std::string& name, double value) { values_[name] = value; }
  void erase(const std::string& name) { values_.erase(name); }
  const Values& values() const { return values_; }

  const SheetTolerance& tolerance() const { return tolerance_; }
  void setTolerance(SheetTolerance tolerance) { tolerance_ = std::move(tolerance); }

  Describes describes() const { return describes_; }
  void describe(Describes what) { describes_ = what; }

  /// Returns the curve that replaces static_stiffness; nullptr if there is none.
  const StaticCurve* curve() const { return curve_.get(); }
  void setCurve(StaticCurve curve) { curve_ = std::make_shared<const StaticCurve>(std::move(curve)); }
  void eraseCurve() { curve_.reset(); }

  /// Returns the points that replace the numbers of the model; empty if there are none.
  const std::vector<SpecifiedPoint>& points() const { return points_; }
  void setPoints(std::vector<SpecifiedPoint> points) { points_ = std::move(points); }

  /// Returns blocks of numbers that override values(), each at its own nominal displacement on the static curve.
  const std::vector<Values>& preloads() const { return preloads_; }
  void setPreloads(std::vector<Values> preloads) { preloads_ = std::move(preloads); }

  /// Sets the units of values in errors and warnings, by default SI. They change no value.
  void writeIn(Units units) { units_ = std::make_shared<const Units>(std::move(units)); }
  /// Returns the unit for the parameter of that name in messages.
  WrittenUnit writtenUnit(std::string_view name) const;

 private:
  /// Linear search: most of these few names differ in their length.
  Values::const_iterator position(std::string_view name) const {
    return std::find_if(values_.begin(), values_.end(), [&](const auto& value) { return value.first == name; });
  }

  Values values_;
  SheetTolerance tolerance_;
  Describes describes_ = Describes::unsaid;
  std::vector<SpecifiedPoint> points_;
  std::vector<Values> preloads_;
  std::shared_ptr<const StaticCurve> curve_;  // shared, as specifications are copied often
  std::shared_ptr<const Units> units_;
};

/// Returns the displacement z_0 [m] of the working point. Throws std::invalid_argument if nominal_force has none.
double nominalDisplacement(const Specification& specification);

/// Returns the table of all numbers of `specification:`.
const std::vector<element::ParameterInfo>& specificationParameters();

/// Returns true for a number of the component that a sheet states and that may be wrong: no working point, no choice.
bool isOfSheet(std::string_view name);

/// The keys of a model's specification.
struct ModelInfo {
  Model model;
  std::string documentation;
  std::vector<std::string> required;
  std::vector<std::vector<std::string>> one_of;  ///< exactly one of each group
  std::vector<std::string> optional;
  std::vector<std::vector<std::string>> two_of;  ///< exactly two of each group
};

const ModelInfo& modelInfo(Model model);

/// Checks the specification against the tables for keys that are unknown, missing, superfluous or out of range. Throws
/// std::invalid_argument that names key, value and what is accepted.
void checkSpecification(Model model, const Specification& specification);

/// Returns the elements of the model that meets the specification of a base; resolve() converts others to one. Throws
/// std::invalid_argument that names key, value and the interval with solutions if there is no solution.
std::vector<element::ElementDescription> estimate(Model model, const Specification& specification);

/// Estimates elements with a linear spring, the tangent, in place of the static curve; none is scaled along the curve.
std::vector<element::ElementDescription> estimateTangent(Model model, const Specification& specification);

}  // namespace rubber_suspension::estimation
