// The list of all laws by their names in component files. The source file of each law enters it into the list.
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

/// Returns the law if its force adds to that of the others, else nullptr.
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

/// Returns a function that makes a law from its parameters of these names. They are in the order of the constructor's
/// arguments or, if `Arguments` is given, of the members of that struct.
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

/// Returns the law of that name, or nullptr.
const ElementType* findElementType(const std::string& name);

/// Checks an entry against its table, fills in defaults and makes the law. Throws std::invalid_argument that names
/// type, parameter, value and what is accepted.
ElementPointer makeElement(const ElementDescription& description);

/// Returns true if an entry describes the rig, not the rubber: it is marked so, or is an effect of the measuring chain.
/// Throws as makeElement does.
bool isOfRig(const ElementDescription& description);

/// Returns the entry with defaults filled in; throws as makeElement does.
ElementDescription complete(const ElementDescription& description);

}  // namespace rubber_suspension::element
