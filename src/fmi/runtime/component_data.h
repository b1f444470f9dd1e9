// The component in an FMU: its specification or elements, and added elements. The exporter writes it for the binary.
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
  std::string name;  ///< name of the component
  std::string guid;  ///< must be the same in modelDescription.xml and in the binary
  estimation::Model model = estimation::Model::elements;
  estimation::Specification specification;  ///< empty for the model `elements`
  Elements elements;                        ///< complete elements of the model `elements`; empty for all other models
  Elements add;                             ///< added elements, complete
  Elements temperature;
  /// Laws with complete elements, set only for six directions. Then all other data except name and GUID are unused.
  std::optional<component::SixDirectionsLaws> six;

  /// Returns the elements that the model lists or estimates from the specification. Throws std::invalid_argument if the
  /// specification has no solution.
  Elements modelElements() const;

  /// Returns the elements of the model, added elements and temperature shifts, in the order of the component file.
  Elements allElements() const;
};

/// Returns the entries with all defaults. Throws std::invalid_argument as element::complete does.
Elements completed(Elements entries);

/// Returns text from which fromJson() reads the same numbers, bit by bit.
std::string toJson(const ComponentData& data);

/// Returns the component from text that toJson() has written. Throws std::exception for any other text.
ComponentData fromJson(const std::string& text);

}  // namespace rubber_suspension::fmi
