// The list of all laws by their names in component files. The source file of a law enters the law into the list.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "rubber_suspension/element/element.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/element/temperature_shift.h"

namespace rubber_suspension::element {

using ElementPointer = std::variant<std::shared_ptr<const ParallelElement>, std::shared_ptr<const DisplacementEffect>,
                                    std::shared_ptr<const ForceEffect>, std::shared_ptr<const SeriesElement>,
                                    std::shared_ptr<const TemperatureShift>>;

/// Returns the law as an Element.
inline const Element& lawOf(const ElementPointer& element) {
  return std::visit([](const auto& law) -> const Element& { return *law; }, element);
}

/// Returns the law if it is a ParallelElement, otherwise nullptr.
inline const ParallelElement* parallelLaw(const ElementPointer& element) {
  const auto* law = std::get_if<std::shared_ptr<const ParallelElement>>(&element);
  return law == nullptr ? nullptr : law->get();
}

/// Describes a law to users: its name, its purpose, its parameters and how to make it.
struct ElementType {
  std::string name;
  std::string documentation;
  std::vector<ParameterInfo> parameters;
  /// Makes the law from values that are complete and in range. Throws std::invalid_argument for values that are each in
  /// range but not compatible with each other.
  std::function<ElementPointer(const ElementDescription&)> make;
};

/// Returns a function that makes a law from its parameters of these names. The names are in the order of the arguments
/// of the constructor or, if a struct `Arguments` is given, in the order of its data members.
template <class Law, class Arguments = void, class... Names>
std::function<ElementPointer(const ElementDescription&)> makes(Names... names) {
  return [=](const ElementDescription& description) -> ElementPointer {
    if constexpr (std::is_void_v<Arguments>) {
      return std::make_shared<const Law>(description.value(names)...);
    } else {
      return std::make_shared<const Law>(Arguments{description.value(names)...});
    }
  };
}

/// Returns all laws in the order of the reference page.
const std::vector<ElementType>& elementTypes();

/// Returns the law of that name, or nullptr if there is none.
const ElementType* findElementType(const std::string& name);

/// Checks an entry of a component file against the parameters of its law, fills in defaults and makes the law. Throws
/// std::invalid_argument with a message that names type, parameter, value and accepted values.
ElementPointer makeElement(const ElementDescription& description);

/// Returns true if an entry describes the rig instead of the rubber: it is marked as part of the rig, or it is an
/// effect of the measuring chain. Throws as makeElement() does.
bool isOfRig(const ElementDescription& description);

/// Returns the entry with defaults filled in. Throws as makeElement() does.
ElementDescription complete(const ElementDescription& description);

}  // namespace rubber_suspension::element
