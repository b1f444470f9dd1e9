// The list of the variables of an FMU, from the tables of laws and models.
#include "fmi/runtime/variables.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

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

// The number of elements decides which variables there are, so it stays as it is.
element::Range settableRange(const element::ParameterInfo& parameter, double value) {
  return parameter.name == "maxwell_elements" ? element::Range::closed(value, value) : parameter.range;
}

}  // namespace

VariableTable::VariableTable(const ComponentData& data) {
  add("time", "s", "time", Causality::independent);
  if (data.six) {
    addSix(data);
    return;
  }
  addOne(data);
  addSpecification(data);
  const bool listed = data.model == estimation::Model::elements;
  if (listed) {
    addElements(data.elements, Place::List::model, Causality::parameter);
  }
  addElements(data.add, Place::List::add, Causality::parameter);
  addElements(data.temperature, Place::List::temperature, Causality::parameter);
  free_count_ = places_.size();
  if (!listed) {
    addElements(data.modelElements(), Place::List::model, Causality::calculated_parameter);
  }
  addTemperature(data.name, component::Component(data.allElements()), data.allElements());
}

void VariableTable::add(const std::string& name, const std::string& unit, const std::string& description,
                        Causality causality) {
  variables_.push_back({name, unit, description, causality, {}, {}});
  if (causality == Causality::input) {
    variables_.back().start = 0.0;
    first_output_ = static_cast<Reference>(variables_.size());
  }
  first_parameter_ = static_cast<Reference>(variables_.size());
}

// A pose of B in A, its rotation in the measure of the component, and the wrench.
void VariableTable::addSix(const ComponentData& data) {
  const std::string rotation =
      data.six->measure == component::RotationMeasure::cardan ? "body-fixed x-y-z angle" : "rotation vector";
  for (std::size_t i = 0; i < component::kDirections; ++i) {
    const auto direction = static_cast<component::Direction>(i);
    const bool turns = component::isRotation(direction);
    add(component::toString(direction), turns ? "rad" : "m",
        (turns ? "rotation of body B in body A, " + rotation : "position of body B in body A") +
            " at the end of the next step",
        Causality::input);
  }
  for (const char* name : {"Fx", "Fy", "Fz", "Mx", "My", "Mz"}) {
    add(name, name[0] == 'F' ? "N" : "N m",
        "of the wrench that has to be applied to body B, at B's origin, to hold the pose; in A's axes",
        Causality::output);
  }
  std::vector<element::ElementDescription> all;
  for (const auto& elements : data.six->elements) {
    all.insert(all.end(), elements.begin(), elements.end());
  }
  addTemperature(data.name, component::SixDirections(*data.six), all);
}

// It starts at the reference of the first shift, where the component is as specified.
template <class Component>
void VariableTable::addTemperature(const std::string& name, const Component& component,
                                   const std::vector<element::ElementDescription>& elements) {
  if (!component.shiftsWithTemperature()) {
    return;
  }
  temperature_ = static_cast<Reference>(variables_.size());
  const auto shift = std::find_if(elements.begin(), elements.end(), [](const element::ElementDescription& element) {
    return element::lawOf(element::makeElement(element)).action() == element::Action::shifts_with_temperature;
  });
  variables_.push_back({"temperature", "degC", "temperature of " + name + " during the next step", Causality::input,
                        shift->value("reference"), component.temperatures()});
}

void VariableTable::addOne(const ComponentData& data) {
  add("displacement", "m",
      "displacement of " + data.name + " at the end of the next step; positive gives a positive force",
      Causality::input);
  add("force", "N", "force that has to be applied to hold the displacement", Causality::output);
  for (const std::string part : {"elastic", "viscous", "friction"}) {
    add("force_" + part, "N", part + " part of the force", Causality::output);
  }
}

void VariableTable::addSpecification(const ComponentData& data) {
  for (const element::ParameterInfo& parameter : estimation::specificationParameters()) {
    if (const auto value = data.specification.find(parameter.name)) {
      addParameter({"specification." + parameter.name, parameter.unit, describe(parameter), Causality::parameter,
                    *value, settableRange(parameter, *value)},
                   {Place::List::specification, 0, parameter.name, 0});
    }
  }
}

void VariableTable::addElements(const std::vector<element::ElementDescription>& elements, Place::List list,
                                Causality causality) {
  const char* group = list == Place::List::add ? "add" : list == Place::List::temperature ? "temperature" : "elements";
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const element::ElementType* type = element::findElementType(elements[i].type);
    if (type == nullptr) {
      throw std::invalid_argument(fmt::format("'{}' is not an element", elements[i].type));
    }
    for (const element::ParameterInfo& parameter : type->parameters) {
      const std::vector<double>& values = elements[i].list(parameter.name);
      for (std::size_t k = 0; k < values.size(); ++k) {
        const std::string index = parameter.is_list ? fmt::format("[{}]", k + 1) : "";
        const std::string name = fmt::format("{}[{}].{}.{}{}", group, i + 1, type->name, parameter.name, index);
        const auto start = causality == Causality::parameter ? std::optional<double>(values[k]) : std::nullopt;
        addParameter({name, parameter.unit, describe(parameter), causality, start, parameter.range},
                     {list, i, parameter.name, k});
      }
    }
  }
}

void VariableTable::addParameter(const Variable& variable, const Place& place) {
  variables_.push_back(variable);
  places_.push_back(place);
}

std::vector<double> VariableTable::startValues() const {
  std::vector<double> values;
  for (std::size_t i = 0; i < free_count_; ++i) {
    values.push_back(variables_[first_parameter_ + i].start.value());
  }
  return values;
}

std::vector<double> VariableTable::calculatedValues(
    const std::vector<element::ElementDescription>& model_elements) const {
  std::vector<double> values;
  for (std::size_t i = free_count_; i < places_.size(); ++i) {
    const Place& place = places_[i];
    const std::vector<double>* list = nullptr;
    if (place.entry < model_elements.size()) {
      const auto found = model_elements[place.entry].values.find(place.key);
      list = found == model_elements[place.entry].values.end() ? nullptr : &found->second;
    }
    element::refuseIf(list == nullptr || place.position >= list->size(),
                      "the specification leads to other elements than that of the FMU; accepted: one that changes "
                      "their numbers alone");
    values.push_back((*list)[place.position]);
  }
  return values;
}

void setValue(ComponentData& data, const Place& place, double value) {
  if (place.list == Place::List::specification) {
    data.specification.set(place.key, value);
    return;
  }
  auto& entries = place.list == Place::List::add           ? data.add
                  : place.list == Place::List::temperature ? data.temperature
                                                           : data.elements;
  entries.at(place.entry).values.at(place.key).at(place.position) = value;
}

}  // namespace rubber_suspension::fmi
