// From what a data sheet says to the elements of a model: the specification, the models, the estimation.
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

/// The name in a component file.
std::string toString(Model model);

/// The model of that name, or nothing.
std::optional<Model> modelFromString(const std::string& name);

/// A unit as the user wrote it.
struct WrittenUnit {
  std::string name;  ///< "kN/mm"
  double size;       ///< of it in the SI unit, 1e6 N/m
};

/// Numbers by the names of specificationParameters() [SI]; loss angles in rad.
class Specification {
 public:
  using Values = std::map<std::string, double, std::less<>>;
  using Units = std::map<std::string, WrittenUnit, std::less<>>;

  bool has(std::string_view name) const { return position(name) != values_.end(); }
  std::optional<double> find(std::string_view name) const {
    const auto found = position(name);
    return found == values_.end() ? std::nullopt : std::optional<double>(found->second);
  }
  /// Throws std::out_of_range where it is missing.
  double at(std::string_view name) const {
    const auto found = position(name);
    return found != values_.end() ? found->second : throw std::out_of_range(std::string(name));
  }
  double valueOr(std::string_view name, double fallback) const { return find(name).value_or(fallback); }
  void set(const std::string& name, double value) { values_[name] = value; }
  void erase(const std::string& name) { values_.erase(name); }
  const Values& values() const { return values_; }

  /// The units in which errors and warnings speak of values; SI for those that are not named. They change no value.
  void writeIn(Units units) { units_ = std::make_shared<const Units>(std::move(units)); }
  /// The unit in which to speak of the parameter of that name.
  WrittenUnit writtenUnit(std::string_view name) const;

 private:
  /// One after the other: of so few names most differ in their length.
  Values::const_iterator position(std::string_view name) const {
    return std::find_if(values_.begin(), values_.end(), [&](const auto& value) { return value.first == name; });
  }

  Values values_;
  std::shared_ptr<const Units> units_;  // shared, as specifications are copied often
};

/// The table of everything that `specification:` may hold.
const std::vector<element::ParameterInfo>& specificationParameters();

/// What a model takes from its specification.
struct ModelInfo {
  Model model;
  std::string documentation;
  std::vector<std::string> required;
  std::vector<std::vector<std::string>> one_of;  ///< of each group exactly one
  std::vector<std::string> optional;
  std::vector<std::vector<std::string>> two_of;  ///< of each group exactly two
};

const ModelInfo& modelInfo(Model model);

/// Check the specification against the tables: unknown, missing, superfluous, out of range.
/// Throws std::invalid_argument that names key, value and what is accepted.
void checkSpecification(Model model, const Specification& specification);

/// The elements of the model that meets the specification.
/// Throws std::invalid_argument that names key, value and the interval that it could take, where there is no solution.
std::vector<element::ElementDescription> estimate(Model model, const Specification& specification);

}  // namespace rubber_suspension::estimation
