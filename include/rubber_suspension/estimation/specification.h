// Specification of a component, its models, and the estimation of their elements. Symbols: K_st static, K_n dynamic,
// K_max maximum stiffness; f_n nominal, f_h high, f_l low, f_b break frequency.
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

/// The models of a component file, with their numbers in the paper (Polach, IAVSD 2015).
enum class Model {
  kelvin_voigt,      ///< M1
  maxwell,           ///< M2 with one Maxwell element
  maxwell_dashpot,   ///< M3
  friction,          ///< M4
  friction_dashpot,  ///< M5
  berg,              ///< M6
  multi_maxwell,     ///< M2 with n_M Maxwell elements
  elements,          ///< a list of elements, which needs no estimation
};

/// Returns the name of a model in a component file.
std::string toString(Model model);

/// Returns the model of that name, or nullopt.
std::optional<Model> modelFromString(const std::string& name);

/// A unit as the user wrote it, for messages.
struct WrittenUnit {
  std::string name;  ///< name such as "kN/mm"
  double size;       ///< factor to the SI unit, for example 1e6 for kN/mm
};

/// The part of a component to which a specification refers.
enum class Describes {
  unsaid,     ///< the model, with a note if elements are added
  base,       ///< the base: the elements of the model without added elements
  component,  ///< the whole component, with added elements
};

/// Returns the name in a component file; "" for `unsaid`.
std::string toString(Describes describes);

/// One measured point of a component, to which a model is fitted.
struct SpecifiedPoint {
  double frequency = 0.0;            ///< [Hz]
  double amplitude = 0.0;            ///< [m]; 0 if no amplitude is given
  std::optional<double> stiffness;   ///< [N/m]
  std::optional<double> loss_angle;  ///< [rad]
  double weight = 1.0;
};

/// Tolerances of the numbers of a data sheet, as standard deviations of their logarithms.
struct SheetTolerance {
  static constexpr double kUsual = 0.1;                ///< tolerance if the user gives none
  static constexpr double kGuess = 2.302585092994046;  ///< ln 10: the value is right to an order of magnitude

  std::optional<double> of_all = {};
  std::map<std::string, double, std::less<>> by_key = {};  ///< tolerances of single numbers, which take precedence

  bool given() const { return of_all || !by_key.empty(); }
  double of(std::string_view key) const {
    const auto found = by_key.find(key);
    return found != by_key.end() ? found->second : of_all.value_or(kUsual);
  }
};

/// Numbers with the names of specificationParameters() [SI], loss angles in rad; optionally a static curve or points.
class Specification {
 public:
  using Values = std::map<std::string, double, std::less<>>;
  using Units = std::map<std::string, WrittenUnit, std::less<>>;

  bool has(std::string_view name) const { return position(name) != values_.end(); }
  std::optional<double> find(std::string_view name) const {
    const auto found = position(name);
    return found == values_.end() ? std::nullopt : std::optional<double>(found->second);
  }
  /// Throws std::out_of_range if there is no number of this name.
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

  /// Returns the points to which the model is fitted; empty if the numbers of the model are used instead.
  const std::vector<SpecifiedPoint>& points() const { return points_; }
  void setPoints(std::vector<SpecifiedPoint> points) { points_ = std::move(points); }

  /// Returns sets of numbers that override values(), each at its own nominal displacement on the static curve.
  const std::vector<Values>& preloads() const { return preloads_; }
  void setPreloads(std::vector<Values> preloads) { preloads_ = std::move(preloads); }

  /// Sets the units that messages use for values, by default SI. This changes no value.
  void writeIn(Units units) { units_ = std::make_shared<const Units>(std::move(units)); }
  /// Returns the unit that messages use for the parameter of this name.
  WrittenUnit writtenUnit(std::string_view name) const;

 private:
  /// Linear search is fast, because most of these few names differ in length.
  Values::const_iterator position(std::string_view name) const {
    return std::find_if(values_.begin(), values_.end(), [&](const auto& value) { return value.first == name; });
  }

  Values values_;
  SheetTolerance tolerance_;
  Describes describes_ = Describes::unsaid;
  std::vector<SpecifiedPoint> points_;
  std::vector<Values> preloads_;
  std::shared_ptr<const StaticCurve> curve_;  // shared, because specifications are copied often
  std::shared_ptr<const Units> units_;
};

/// Returns the displacement z_0 [m] of the working point. Throws std::invalid_argument if none has the nominal_force.
double nominalDisplacement(const Specification& specification);

/// Returns the table of all numbers of `specification:`.
const std::vector<element::ParameterInfo>& specificationParameters();

/// Returns true for a property of the component, which may be wrong; false for a working point or a choice.
bool isOfSheet(std::string_view name);

/// The keys of a model's specification.
struct ModelInfo {
  Model model;
  std::string documentation;
  std::vector<std::string> required;
  std::vector<std::vector<std::string>> one_of;  ///< exactly one key of each group is required
  std::vector<std::string> optional;
  std::vector<std::vector<std::string>> two_of;  ///< exactly two keys of each group are required
};

const ModelInfo& modelInfo(Model model);

/// Checks the specification against the tables for unknown, missing or superfluous keys and values out of range. Throws
/// std::invalid_argument that states key, value and what is accepted.
void checkSpecification(Model model, const Specification& specification);

/// Returns the elements of the model that meets the specification of a base; resolve() converts other specifications.
/// Throws std::invalid_argument that states key, value and the interval with solutions if there is no solution.
std::vector<element::ElementDescription> estimate(Model model, const Specification& specification);

/// Returns the elements with a linear spring, the tangent of the static curve, and no element scaled along the curve.
std::vector<element::ElementDescription> estimateTangent(Model model, const Specification& specification);

}  // namespace rubber_suspension::estimation
