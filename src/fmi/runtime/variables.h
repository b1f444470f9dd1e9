// The list of the variables of an FMU, which modelDescription.xml and the binary share.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fmi/runtime/component_data.h"

namespace rubber_suspension::fmi {

/// Index of a variable in the list, which importers use as its value reference.
using Reference = std::uint32_t;

/// Every list begins with time, inputs and outputs. The parameters follow, then the temperature if the component has
/// temperature shifts. These references are valid for one direction; six directions have six inputs and six outputs.
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
  calculated_parameter,  ///< parameter of an element that the model estimates from the specification
};

struct Place {
  Elements ComponentData::* list = nullptr;  ///< list of elements; nullptr for the specification
  std::size_t entry = 0;                     ///< index in the list
  std::string key = {};                      ///< name of the parameter
  std::size_t position = 0;                  ///< index in a list of numbers; 0 for a single number

  /// Sets the value in the data. The parameter must not be a calculated one.
  void put(ComponentData& data, double value) const;
};

struct Variable {
  std::string name;
  std::string unit;  ///< unit in UDUNITS spelling, "1" for none
  std::string description;
  Causality causality = Causality::parameter;
  std::optional<double> start = {};  ///< start value of inputs and parameters
  element::Range range = {};         ///< may have open ends, which FMI lacks; the description states them
  Place place = {};                  ///< place of the value of a parameter
};

/// All variables of one component. The parameters have this order: specification, listed elements of the model, added
/// elements, temperature shifts, calculated parameters.
class VariableTable {
 public:
  /// Throws std::invalid_argument if the specification has no solution.
  explicit VariableTable(const ComponentData& data);

  const std::vector<Variable>& variables() const { return variables_; }

  /// Returns the reference of the temperature, or the number of variables if there is no temperature shift.
  Reference temperature() const { return temperature_; }

  Reference firstOutput() const { return first_output_; }
  Reference firstParameter() const { return first_parameter_; }

  /// Returns the values that the data contain for the parameters that can be set.
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
