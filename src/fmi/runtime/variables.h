// The variables of an FMU: the same list for modelDescription.xml and for the binary.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fmi/runtime/component_data.h"

namespace rubber_suspension::fmi {

/// Place of a variable in the list, which importers use as its value reference.
using Reference = std::uint32_t;

/// Every list begins with time, inputs and outputs. The parameters follow, then the temperature if the component shifts
/// with it. These references are for one direction; six directions have six inputs and six outputs.
namespace reference {
constexpr Reference kTime = 0;
constexpr Reference kDisplacement = 1;
constexpr Reference kForce = 2;
}  // namespace reference

enum class Causality {
  independent,
  input,
  output,
  parameter,             ///< can be set until the initialisation ends
  calculated_parameter,  ///< of an element that the model estimates from the specification
};

/// Place of the value of a parameter in the data of a component.
struct Place {
  Elements ComponentData::* list = nullptr;  ///< nullptr: the specification
  std::size_t entry = 0;                     ///< of the list
  std::string key = {};                      ///< name of the parameter
  std::size_t position = 0;                  ///< in a list of numbers; 0 for a single one

  /// Sets the value in the data. Must not be called for calculated parameters.
  void put(ComponentData& data, double value) const;
};

/// One variable; all are real numbers.
struct Variable {
  std::string name;
  std::string unit;  ///< in UDUNITS spelling, "1" for none
  std::string description;
  Causality causality = Causality::parameter;
  std::optional<double> start = {};  ///< of inputs and parameters
  element::Range range = {};         ///< FMI has no open ends; the description states them
  Place place = {};                  ///< of parameters
};

/// All variables of one component. Parameters are in the order: specification, elements of the model if they are
/// listed, added elements, shifts with temperature; then the calculated ones.
class VariableTable {
 public:
  /// Throws std::invalid_argument if the specification has no solution.
  explicit VariableTable(const ComponentData& data);

  const std::vector<Variable>& variables() const { return variables_; }

  /// Returns the reference of the temperature; without a shift with temperature it exceeds those of all variables.
  Reference temperature() const { return temperature_; }

  Reference firstOutput() const { return first_output_; }
  Reference firstParameter() const { return first_parameter_; }

  /// Returns the values in the data of the parameters that can be set.
  std::vector<double> startValues() const;

  /// Returns the values of the calculated parameters for these elements. Throws std::invalid_argument if they are not
  /// the elements of the table.
  std::vector<double> calculatedValues(const Elements& model_elements) const;

 private:
  void addOne(const ComponentData& data);
  void addSix(const ComponentData& data);
  void addElements(const std::string& group, const Elements& elements, Elements ComponentData::* list,
                   Causality causality);
  template <class Value>
  std::vector<double> collect(Causality causality, Value value) const;
  template <class Component>
  void addTemperature(const std::string& name, const Component& component, const Elements& elements);

  std::vector<Variable> variables_;
  Reference first_output_ = 0;
  Reference first_parameter_ = 0;
  Reference temperature_ = 0;
};

}  // namespace rubber_suspension::fmi
