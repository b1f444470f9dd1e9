// The component file: YAML that the node and all commands load alike, and write.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/estimation/specification.h"
#include "rubber_suspension/io/rig_tolerances.h"

namespace rubber_suspension::io {

/// One component as a file describes it.
struct ComponentDescription {
  std::string name;  ///< a ROS base name
  estimation::Model model = estimation::Model::elements;
  estimation::Specification specification;            ///< of every model but `elements`
  std::vector<element::ElementDescription> elements;  ///< of the model `elements` only
  std::vector<element::ElementDescription> add;       ///< effects on top
  std::optional<RigTolerances> rig;                   ///< tolerances of the rig that measures it, where given

  /// All elements: those that the model estimates, or lists, and those added.
  /// Throws std::invalid_argument where the specification has no solution.
  std::vector<element::ElementDescription> allElements() const;

  component::Component makeComponent() const { return component::Component(allElements()); }
};

/// A file that was refused. what() is one line: file:line, component, key, value and what would be accepted.
class ComponentFileError : public std::runtime_error {
 public:
  explicit ComponentFileError(const std::string& message);
};

/// Bounds on a component file; one beyond them is refused.
constexpr std::size_t kMaximumComponentFileSize = 1024 * 1024;  // bytes
constexpr std::size_t kMaximumComponents = 256;
constexpr std::size_t kMaximumElements = 1000;     // entries of one `elements` or `add`
constexpr std::size_t kMaximumListLength = 10000;  // numbers of one list

/// Load and check everything, estimation included. Numbers are SI, text carries its unit. Refused are unknown, missing
/// and repeated keys, wrong types, units of another dimension, values out of range or not finite, names that are no ROS
/// base name, and specifications without solution. Throws ComponentFileError.
std::vector<ComponentDescription> loadComponentFile(const std::string& path);

/// The same from text; `source` stands for the file's name in errors.
std::vector<ComponentDescription> parseComponentFile(const std::string& text, const std::string& source);

/// The component of that name; with an empty name the only one. Throws ComponentFileError that lists the names.
const ComponentDescription& selectComponent(const std::vector<ComponentDescription>& components,
                                            const std::string& name);

/// YAML that parseComponentFile reads back to the same numbers, bit by bit.
std::string toYaml(const std::vector<ComponentDescription>& components);

}  // namespace rubber_suspension::io
