// The component within an FMU: the specification or the elements, and what was added; written by the exporter,
// read by the binary.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/component/six_directions.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension::fmi {

using Elements = std::vector<element::ElementDescription>;

struct ComponentData {
  std::string name;  ///< of the component
  std::string guid;  ///< by which an importer checks that modelDescription.xml and binary belong together
  estimation::Model model = estimation::Model::elements;
  estimation::Specification specification;  ///< empty for the model `elements`
  Elements elements;                        ///< of the model `elements`, complete; empty for all others
  Elements add;                             ///< complete
  /// Shifts with temperature, complete: those of the key `temperature`.
  Elements temperature;
  /// Set for a component of six directions, with complete elements; of the above it has only name and GUID.
  std::optional<component::SixDirectionsLaws> six;

  /// Returns the elements that the model estimates from the specification, or lists. Throws std::invalid_argument
  /// without a solution.
  Elements modelElements() const;

  /// Returns elements of the model, added elements and temperature shifts, in the order of the component file.
  Elements allElements() const;
};

/// With all parameters.
Elements completed(Elements entries);

/// Text that fromJson() reads back to the same numbers, bit by bit.
std::string toJson(const ComponentData& data);

/// Throws std::exception on any other text.
ComponentData fromJson(const std::string& text);

}  // namespace rubber_suspension::fmi
