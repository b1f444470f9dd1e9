// Component files: YAML that the node and all commands read and write.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/component/preload.h"
#include "rubber_suspension/component/six_directions.h"
#include "rubber_suspension/estimation/specification.h"
#include "rubber_suspension/estimation/whole.h"
#include "rubber_suspension/io/rig_tolerances.h"

namespace rubber_suspension::io {

struct SixDirectionsDescription;

/// One component as a file describes it. Setting the specification, which is only possible as a whole, estimates the
/// elements, so that both always agree.
class ComponentDescription {
 public:
  /// Makes a component of the model `elements` without elements.
  ComponentDescription() = default;

  /// Makes a component of the model `elements`.
  ComponentDescription(std::string component, std::vector<element::ElementDescription> list)
      : name(std::move(component)), elements_(std::move(list)) {}

  /// Makes a component of any other model, with added elements. Throws std::invalid_argument if no elements fulfil the
  /// specification.
  ComponentDescription(std::string component, estimation::Model model, estimation::Specification specification,
                       std::vector<element::ElementDescription> added = {});

  std::string name;                              ///< a ROS base name
  std::vector<element::ElementDescription> add;  ///< elements added to those of the model
  std::optional<RigTolerances> rig;              ///< tolerances of the rig that measures it, if given
  /// Law of the temperature dependence, wlf_shift or arrhenius_shift, if given.
  std::optional<element::ElementDescription> temperature;
  std::optional<element::Range> valid_displacement;  ///< range of validity [m], if given
  std::vector<std::string> excluded_effects;         ///< names of effects that the construction rules out
  /// Tolerance of the values of `elements`; the tolerance of an entry, such as "spring[0]", takes precedence.
  estimation::SheetTolerance tolerance;
  bool holds_fluid = false;  ///< true: a resonance in its force is attributed to the fluid, not to the fixture
  /// Units in the file, by SI unit; the first one if the file uses several.
  std::map<std::string, std::string> units;
  /// Set for a component of six directions, whose only other member in use is the name; otherwise nullptr.
  std::shared_ptr<const SixDirectionsDescription> six;

  estimation::Model model() const { return model_; }

  /// Returns the specification of the base, from which estimate() makes elements(), even if the file describes the
  /// whole component. Empty for the model `elements`.
  const estimation::Specification& specification() const { return resolved_.specification; }

  /// Returns the specification as given, such as that of the whole component, or points.
  const estimation::Specification& written() const { return written_; }

  /// Returns specification() with what its derivation from written() found: notes and misfits of points.
  const estimation::Resolved& resolved() const { return resolved_; }

  /// Returns the elements that the model estimates from the specification, or lists, without added ones.
  const std::vector<element::ElementDescription>& elements() const { return elements_; }

  /// Sets another specification, of the base or of the whole component with its present added elements. Throws
  /// std::invalid_argument, without any change, if no elements fulfil it; std::logic_error for the model `elements`,
  /// which has no specification.
  void specify(estimation::Specification specification);

  /// Returns the elements of the model, the added elements and the shift with temperature. Throws
  /// std::invalid_argument for a component of six directions.
  std::vector<element::ElementDescription> allElements() const;

  /// Returns the component without the elements of the rig that measured it (element::isOfRig()), in all directions.
  ComponentDescription withoutRig() const;

  /// Returns the displacements [m] outside which the force is extrapolated: `valid_displacement`, else the intersection
  /// of the ranges of its spring tables, else nullopt.
  std::optional<element::Range> validDisplacement() const;

  /// Throws as allElements() does.
  component::Component makeComponent() const { return component::Component(allElements()); }

 private:
  estimation::Model model_ = estimation::Model::elements;
  estimation::Specification written_;
  estimation::Resolved resolved_;
  std::vector<element::ElementDescription> elements_;
};

/// A component of six directions as a file describes it.
struct SixDirectionsDescription {
  /// Components of one direction, named COMPONENT_DIRECTION; rotations in rad and N m; nullopt: the direction is free.
  std::array<std::optional<ComponentDescription>, component::kDirections> directions;
  std::array<std::optional<component::Preload>, component::kDirections> preload;
  std::vector<component::PreloadTable> tables;
  component::SixDirectionsLaws arrangement;  ///< couplings, rotation measure and frames, without elements
  /// The frames of `arrangement` on the bodies as numbers: position [m], rotation in the rotation measure [rad].
  component::SixNumbers frame_on_a = component::SixNumbers::Zero();
  component::SixNumbers frame_on_b = component::SixNumbers::Zero();

  /// Returns the factor of the tables on a direction's forces. Throws std::invalid_argument if a preload is missing.
  double factorOf(component::Direction direction) const;

  /// Throws std::invalid_argument, which begins with the direction, if its elements cannot be coupled or scaled.
  component::SixDirections makeComponent() const;
};

/// A component file was refused. what() is one line: file:line, component, key, value and what would be accepted.
class ComponentFileError : public std::runtime_error {
 public:
  explicit ComponentFileError(const std::string& message);
};

/// Bounds on a component file; a file that exceeds one is refused.
constexpr std::size_t kMaximumComponentFileSize = 1024 * 1024;  // bytes
constexpr std::size_t kMaximumComponents = 256;
constexpr std::size_t kMaximumElements = 1000;     // entries of one `elements` or `add`
constexpr std::size_t kMaximumListLength = 10000;  // numbers of one list

/// Reads and checks a file, and estimates its elements. Numbers are SI; text contains its unit. Throws
/// ComponentFileError for unknown, missing and repeated keys, wrong types, units of another dimension, values that are
/// out of range or not finite, names that are not ROS base names, and specifications without a solution.
std::vector<ComponentDescription> loadComponentFile(const std::string& path);

/// Parses the text of a component file; errors name the file as `source`. Throws as loadComponentFile() does.
std::vector<ComponentDescription> parseComponentFile(const std::string& text, const std::string& source);

/// Returns the component with this name; an empty name selects the only component. Throws ComponentFileError, which
/// begins with `source` (the name of the file), if given, and lists the names.
const ComponentDescription& selectComponent(const std::vector<ComponentDescription>& components,
                                            const std::string& name, const std::string& source = "");

/// Format of numbers and notes. A place is a numberPlace() or "specification.static_stiffness", preceded by
/// "directions.x." for six directions.
struct YamlStyle {
  std::string head;  ///< comment lines at the top
  /// Returns the text of a number [SI] at a place; default: the shortest that reads back as the same number.
  std::function<std::string(const std::string& place, double value)> number;
  std::function<std::string(const std::string& place)> note;  ///< comment on the number; may be empty
};

/// Returns "add[0].stiffness", or "add[0].stiffness[1]" for an entry of a list; a negative index means no list.
std::string numberPlace(const std::string& entry, const std::string& key, int index);

/// Returns YAML that parseComponentFile reads back to the same numbers, bit by bit, unless the style rounds.
std::string toYaml(const std::vector<ComponentDescription>& components, const YamlStyle& style = {});

}  // namespace rubber_suspension::io
