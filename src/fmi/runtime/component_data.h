// The component in an FMU: the specification or the elements, and what was added. The exporter writes it, the binary
// reads it.
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
  /// Set for a component of six directions, with complete elements; it has only name and GUID besides.
  std::optional<component::SixDirectionsLaws> six;

  /// Returns the elements that the model lists or estimates from the specification. Throws std::invalid_argument if
  /// that has no solution.
  Elements modelElements() const;

  /// Returns the elements of the model, added elements and temperature shifts, in the order of the component file.
  Elements allElements() const;
};

/// Returns the entries with all defaults. Throws std::invalid_argument as element::complete does.
Elements completed(Elements entries);

/// Returns text that fromJson() reads back to the same numbers, bit by bit.
std::string toJson(const ComponentData& data);

/// Returns the component of such a text. Throws std::exception on any other text.
ComponentData fromJson(const std::string& text);

}  // namespace rubber_suspension::fmi
