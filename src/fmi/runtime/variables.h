// The variables of an FMU: the same list for modelDescription.xml and for the binary.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fmi/runtime/component_data.h"

namespace rubber_suspension::fmi {

/// The place of a variable in the list, by which an importer names it.
using Reference = std::uint32_t;

/// The variables that every FMU has come first: the time, inputs, outputs. The parameters follow, and the temperature
/// where it does anything. These are the references of one direction; of six there are six inputs and six outputs.
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

  /// Not for parameters that are calculated.
  void put(ComponentData& data, double value) const;
};

/// One variable; all are real numbers.
struct Variable {
  std::string name;
  std::string unit;  ///< in UDUNITS spelling, "1" for none
  std::string description;
  Causality causality = Causality::parameter;
  std::optional<double> start = {};  ///< of inputs and parameters
  element::Range range = {};         ///< an open end is one by the description alone, FMI has no word for it
  Place place = {};                  ///< of parameters
};

/// All variables of one component. Parameters are in the order: specification, elements of the model if they are
/// listed, added elements, shifts with temperature; then the calculated ones.
class VariableTable {
 public:
  /// Throws std::invalid_argument where the specification has no solution.
  explicit VariableTable(const ComponentData& data);

  const std::vector<Variable>& variables() const { return variables_; }

  /// The reference of the temperature; one that no variable has where the component has no shift with temperature.
  Reference temperature() const { return temperature_; }

  Reference firstOutput() const { return first_output_; }
  Reference firstParameter() const { return first_parameter_; }

  /// Values of the parameters that can be set, as the data has them.
  std::vector<double> startValues() const;

  /// Values of the calculated parameters that these elements have. Throws std::invalid_argument where they are other
  /// elements than those of the table.
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
