// The list of all laws by the name that a component file uses; a new law is one file here and one line in the list.
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

/// The part that all laws have in common.
inline const Element& lawOf(const ElementPointer& element) {
  return std::visit([](const auto& law) -> const Element& { return *law; }, element);
}

/// The law as one beside others, or nullptr where it is of another kind.
inline const ParallelElement* parallelLaw(const ElementPointer& element) {
  const auto* law = std::get_if<std::shared_ptr<const ParallelElement>>(&element);
  return law == nullptr ? nullptr : law->get();
}

/// A law as users see it: its name, what it is for, its parameters and how to make one.
struct ElementType {
  std::string name;
  std::string documentation;
  std::vector<ParameterInfo> parameters;
  /// Makes the law from values that are complete and in range. Throws std::invalid_argument where a combination of
  /// values that are each in range makes no sense.
  std::function<ElementPointer(const ElementDescription&)> make;
};

/// Makes a law from its parameters of these names, in the order of its constructor's arguments or, where these are one
/// struct, of the members of it.
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

/// All laws, in the order of the reference page.
const std::vector<ElementType>& elementTypes();

/// The law of that name, or nullptr.
const ElementType* findElementType(const std::string& name);

/// Checks an entry against its table, fills in defaults and makes the law. Throws std::invalid_argument that names
/// type, parameter, value and what is accepted.
ElementPointer makeElement(const ElementDescription& description);

/// True if an entry belongs to the rig, not to the rubber: it is marked so, or is an effect of the measuring chain.
/// Throws as makeElement does.
bool isOfRig(const ElementDescription& description);

/// The entry with defaults filled in; throws as makeElement does.
ElementDescription complete(const ElementDescription& description);

}  // namespace rubber_suspension::element
