// The list of all laws, and the check of an entry of a component file against the parameters of its law.
#include "rubber_suspension/element/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "element/each.h"
#include "element/largest_number.h"
#include "element/registry.h"
#include "element/suggestion.h"

namespace rubber_suspension::element {
namespace {

using Entries = std::map<int, ElementType>;

// Returns the list, sorted by place. It is static in a function, since laws register themselves while static objects
// are initialised, in any order.
Entries& entries() {
  static Entries list;
  return list;
}

const ElementType& requireType(const std::string& name) {
  if (const ElementType* type = findElementType(name)) {
    return *type;
  }
  const std::vector<std::string> names = namesOf(elementTypes());
  throw std::invalid_argument(fmt::format("type: '{}' is not an element{}; accepted: {}", name, didYouMean(name, names),
                                          fmt::join(names, ", ")));
}

void checkValue(const ElementType& type, const ParameterInfo& parameter, const std::vector<double>& values) {
  if (!parameter.is_list && values.size() != 1) {
    throw std::invalid_argument(
        fmt::format("{}.{}: has {} numbers; accepted: one number", type.name, parameter.name, values.size()));
  }
  for (const double value : values) {
    if (!parameter.range.contains(value)) {
      refuseValue(type.name, parameter.name, value, parameter.unit, acceptedFor(value, parameter.range));
    }
  }
}

}  // namespace

ElementEntry::ElementEntry(int place, ElementType type) {
  if (!entries().emplace(place, std::move(type)).second) {
    throw std::logic_error(fmt::format("two laws have the same place: {}", place));
  }
}

const std::vector<ElementType>& elementTypes() {
  static const std::vector<ElementType> types = each(entries(), &Entries::value_type::second);
  return types;
}

const ElementType* findElementType(const std::string& name) {
  const auto& types = elementTypes();
  const auto found =
      std::find_if(types.begin(), types.end(), [&](const ElementType& type) { return type.name == name; });
  return found == types.end() ? nullptr : &*found;
}

ElementDescription complete(const ElementDescription& description) {
  const ElementType& type = requireType(description.type);
  for (const auto& [name, values] : description.values) {
    const ParameterInfo* parameter = findParameter(type.parameters, name);
    if (parameter == nullptr) {
      const std::vector<std::string> names = namesOf(type.parameters);
      throw std::invalid_argument(fmt::format("{}.{}: unknown key{}; accepted: {}", type.name, name,
                                              didYouMean(name, names), fmt::join(names, ", ")));
    }
    checkValue(type, *parameter, values);
  }
  ElementDescription result = description;
  for (const ParameterInfo& parameter : type.parameters) {
    if (result.values.count(parameter.name) != 0) {
      continue;
    }
    if (!parameter.default_value) {
      throw std::invalid_argument(fmt::format("{}.{} is missing; accepted: {} [{}], {}", type.name, parameter.name,
                                              parameter.documentation, parameter.unit, describe(parameter.range)));
    }
    result.values[parameter.name] = {*parameter.default_value};
  }
  return result;
}

bool isOfRig(const ElementDescription& description) {
  return description.of_rig || lawOf(makeElement(description)).ofMeasuringChain();
}

ElementPointer makeElement(const ElementDescription& description) {
  const ElementDescription full = complete(description);
  return requireType(full.type).make(full);
}

}  // namespace rubber_suspension::element
