// The list of the variables of an FMU, which is made from the parameter tables of laws and models.
#include "fmi/runtime/variables.h"

#include <algorithm>

#include "element/refuse.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::fmi {
namespace {

std::string describe(const element::ParameterInfo& parameter) {
  const element::Range& range = parameter.range;
  const bool open = range.open_lower || range.open_upper;
  return parameter.documentation + (open ? "; " + element::describe(range) : "");
}

// The number of elements cannot be set, because it determines which variables exist.
element::Range settableRange(const element::ParameterInfo& parameter, double value) {
  return parameter.name == "maxwell_elements" ? element::Range::closed(value, value) : parameter.range;
}

}  // namespace

VariableTable::VariableTable(const ComponentData& data) {
  variables_.push_back({"time", "s", "time", Causality::independent});
  if (data.six) {
    addSix(data);
  } else {
    addOne(data);
  }
}

void VariableTable::addOne(const ComponentData& data) {
  variables_.push_back(
      {"displacement", "m",
       "displacement of " + data.name + " at the end of the next step; a positive displacement gives a positive force",
       Causality::input, 0.0});
  variables_.push_back({"force", "N", "force that must be applied to hold the displacement", Causality::output});
  for (const std::string part : {"elastic", "viscous", "friction"}) {
    variables_.push_back({"force_" + part, "N", part + " part of the force", Causality::output});
  }
  first_output_ = reference::kForce;
  first_parameter_ = static_cast<Reference>(variables_.size());
  for (const element::ParameterInfo& parameter : estimation::specificationParameters()) {
    if (const auto value = data.specification.find(parameter.name)) {
      const Place place = {nullptr, 0, parameter.name};
      variables_.push_back({"specification." + parameter.name, parameter.unit, describe(parameter),
                            Causality::parameter, value, settableRange(parameter, *value), place});
    }
  }
  addElements("elements", data.elements, &ComponentData::elements, Causality::parameter);
  addElements("add", data.add, &ComponentData::add, Causality::parameter);
  addElements("temperature", data.temperature, &ComponentData::temperature, Causality::parameter);
  if (data.model != estimation::Model::elements) {
    addElements("elements", data.modelElements(), nullptr, Causality::calculated_parameter);
  }
  addTemperature(data.name, component::Component(data.allElements()), data.allElements());
}

// Adds the pose of B in A, with the rotation in the measure of the component, and the wrench.
void VariableTable::addSix(const ComponentData& data) {
  const std::string rotation =
      data.six->measure == component::RotationMeasure::cardan ? "body-fixed x-y-z angle" : "rotation vector";
  for (std::size_t i = 0; i < component::kDirections; ++i) {
    const auto direction = static_cast<component::Direction>(i);
    const bool turns = component::isRotation(direction);
    variables_.push_back({component::toString(direction), turns ? "rad" : "m",
                          (turns ? "rotation of body B in body A, " + rotation : "position of body B in body A") +
                              " at the end of the next step",
                          Causality::input, 0.0});
  }
  first_output_ = static_cast<Reference>(variables_.size());
  for (const char* name : {"Fx", "Fy", "Fz", "Mx", "My", "Mz"}) {
    variables_.push_back(
        {name, name[0] == 'F' ? "N" : "N m",
         "component of the wrench that must be applied to body B, at B's origin, to hold the pose; in the axes of A",
         Causality::output});
  }
  first_parameter_ = static_cast<Reference>(variables_.size());
  Elements all;
  for (const Elements& elements : data.six->elements) {
    all.insert(all.end(), elements.begin(), elements.end());
  }
  addTemperature(data.name, component::SixDirections(*data.six), all);
}

// Adds the variable for the temperature, whose start value is the reference temperature of the first shift.
template <class Component>
void VariableTable::addTemperature(const std::string& name, const Component& component, const Elements& elements) {
  temperature_ = static_cast<Reference>(variables_.size());
  if (component.shiftsWithTemperature()) {
    const auto shift = std::find_if(elements.begin(), elements.end(), [](const element::ElementDescription& element) {
      return element::lawOf(element::makeElement(element)).action() == element::Action::shifts_with_temperature;
    });
    variables_.push_back({"temperature", "degC", "temperature of " + name + " during the next step", Causality::input,
                          shift->value("reference"), component.temperatures()});
  }
}

void VariableTable::addElements(const std::string& group, const Elements& elements, Elements ComponentData::* list,
                                Causality causality) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const element::ElementType* type = element::findElementType(elements[i].type);
    element::refuseIf(type == nullptr, "'{}' is not an element", elements[i].type);
    for (const element::ParameterInfo& parameter : type->parameters) {
      const std::vector<double>& values = elements[i].list(parameter.name);
      for (std::size_t k = 0; k < values.size(); ++k) {
        const std::string index = parameter.is_list ? fmt::format("[{}]", k + 1) : "";
        const auto start = causality == Causality::parameter ? std::optional<double>(values[k]) : std::nullopt;
        const std::string name = fmt::format("{}[{}].{}.{}{}", group, i + 1, type->name, parameter.name, index);
        const Place place = {list, i, parameter.name, k};
        variables_.push_back({name, parameter.unit, describe(parameter), causality, start, parameter.range, place});
      }
    }
  }
}

template <class Value>
std::vector<double> VariableTable::collect(Causality causality, Value value) const {
  std::vector<double> values;
  for (const Variable& variable : variables_) {
    if (variable.causality == causality) {
      values.push_back(value(variable));
    }
  }
  return values;
}

std::vector<double> VariableTable::startValues() const {
  return collect(Causality::parameter, [](const Variable& variable) { return variable.start.value(); });
}

std::vector<double> VariableTable::calculatedValues(const Elements& model_elements) const try {
  return collect(Causality::calculated_parameter, [&](const Variable& variable) {
    const Place& place = variable.place;
    return model_elements.at(place.entry).list(place.key).at(place.position);
  });
} catch (const std::out_of_range&) {
  throw std::invalid_argument(
      "the specification leads to other elements than those of the FMU; accepted: a specification that only changes "
      "values of its elements");
}

void Place::put(ComponentData& data, double value) const {
  if (list == nullptr) {
    data.specification.set(key, value);
  } else {
    (data.*list).at(entry).values.at(key).at(position) = value;
  }
}

}  // namespace rubber_suspension::fmi
