// Component files: the YAML files in which the node and the commands read and write components.
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

/// One component as a component file describes it. The specification can only be set as a whole. Setting it estimates
/// the elements, so that specification and elements always agree.
class ComponentDescription {
 public:
  /// Makes a component of the model `elements` without elements.
  ComponentDescription() = default;

  /// Makes a component of the model `elements`.
  ComponentDescription(std::string component, std::vector<element::ElementDescription> list)
      : name(std::move(component)), elements_(std::move(list)) {}

  /// Makes a component of any model except `elements`, with added elements. Throws std::invalid_argument if no elements
  /// fulfil the specification.
  ComponentDescription(std::string component, estimation::Model model, estimation::Specification specification,
                       std::vector<element::ElementDescription> added = {});

  std::string name;                              ///< a ROS base name
  std::vector<element::ElementDescription> add;  ///< elements in addition to the elements of the model
  std::optional<RigTolerances> rig;              ///< tolerances of the rig that measures the component, if given
  /// Law of the temperature dependence, wlf_shift or arrhenius_shift, if given.
  std::optional<element::ElementDescription> temperature;
  std::optional<element::Range> valid_displacement;  ///< range of validity [m], if given
  std::vector<std::string> excluded_effects;  ///< names of effects that the construction of the component rules out
  /// Tolerance of the values of `elements`; the tolerance of an entry, such as "spring[0]", takes precedence.
  estimation::SheetTolerance tolerance;
  bool holds_fluid = false;  ///< true: a resonance of the force is attributed to the fluid, not to the fixture
  /// The unit that the file uses for each SI unit, or the first of several units.
  std::map<std::string, std::string> units;
  /// Set for a component of six directions, for which all other data except the name are unused. Otherwise nullptr.
  std::shared_ptr<const SixDirectionsDescription> six;

  estimation::Model model() const { return model_; }

  /// Returns the specification of the component without added elements, from which estimate() makes elements(). It is
  /// empty for the model `elements`.
  const estimation::Specification& specification() const { return resolved_.specification; }

  /// Returns the specification as the file states it, for example for the whole component or as points of a curve.
  const estimation::Specification& written() const { return written_; }

  /// Returns specification() together with the notes and the misfits of points from its derivation.
  const estimation::Resolved& resolved() const { return resolved_; }

  /// Returns the elements that the model estimates from the specification or lists, without added elements.
  const std::vector<element::ElementDescription>& elements() const { return elements_; }

  /// Sets another specification, which describes the whole component or the component without its added elements. If no
  /// elements fulfil it, throws std::invalid_argument and changes nothing. Throws std::logic_error for the model
  /// `elements`, which has no specification.
  void specify(estimation::Specification specification);

  /// Returns the elements of the model, the added elements and the temperature shift. Throws std::invalid_argument for
  /// a component of six directions.
  std::vector<element::ElementDescription> allElements() const;

  /// Returns the component without the elements of the rig that measured it (element::isOfRig()), in all directions.
  ComponentDescription withoutRig() const;

  /// Returns the range of displacements [m] outside which the force is extrapolated: `valid_displacement` or, if it is
  /// not given, the intersection of the ranges of the spring tables. Returns nullopt if there are none.
  std::optional<element::Range> validDisplacement() const;

  /// Throws as allElements() does.
  component::Component makeComponent() const { return component::Component(allElements()); }

 private:
  estimation::Model model_ = estimation::Model::elements;
  estimation::Specification written_;
  estimation::Resolved resolved_;
  std::vector<element::ElementDescription> elements_;
};

/// A component of six directions as a component file describes it.
struct SixDirectionsDescription {
  /// Components of one direction, named COMPONENT_DIRECTION, or nullopt for a free direction. Rotations are in rad and
  /// N m.
  std::array<std::optional<ComponentDescription>, component::kDirections> directions;
  std::array<std::optional<component::Preload>, component::kDirections> preload;
  std::vector<component::PreloadTable> tables;
  component::SixDirectionsLaws arrangement;  ///< couplings, rotation measure and frames, without elements
  /// The frames of `arrangement` on the bodies as numbers: position [m], rotation in the rotation measure [rad].
  component::SixNumbers frame_on_a = component::SixNumbers::Zero();
  component::SixNumbers frame_on_b = component::SixNumbers::Zero();

  /// Returns the factor by which the preload tables multiply the forces of a direction. Throws std::invalid_argument if
  /// a preload is missing.
  double factorOf(component::Direction direction) const;

  /// Throws std::invalid_argument, which begins with a direction, if its elements cannot be coupled or scaled.
  component::SixDirections makeComponent() const;
};

/// Thrown if a component file is refused. what() is one line with file:line, component, key, value and accepted values.
class ComponentFileError : public std::runtime_error {
 public:
  explicit ComponentFileError(const std::string& message);
};

/// Limits of a component file, which is refused if it exceeds one of them.
constexpr std::size_t kMaximumComponentFileSize = 1024 * 1024;  // bytes
constexpr std::size_t kMaximumComponents = 256;
constexpr std::size_t kMaximumElements = 1000;     // entries of one list `elements` or `add`
constexpr std::size_t kMaximumListLength = 10000;  // numbers in one list

/// Reads and checks a file, and estimates its elements. A number is in the SI unit; a text contains a unit. Throws
/// ComponentFileError for unknown, missing and repeated keys, wrong types, units of another dimension, values that are
/// out of range or not finite, names that are not ROS base names, and specifications without a solution.
std::vector<ComponentDescription> loadComponentFile(const std::string& path);

/// Parses the text of a component file. Errors name the file as `source`. Throws as loadComponentFile() does.
std::vector<ComponentDescription> parseComponentFile(const std::string& text, const std::string& source);

/// Returns the component with this name or, for an empty name, the only component. Throws ComponentFileError, which
/// begins with `source` (the name of the file), if given, and lists the names of the components.
const ComponentDescription& selectComponent(const std::vector<ComponentDescription>& components,
                                            const std::string& name, const std::string& source = "");

/// Format of numbers and notes. `place` is the path of a number: a numberPlace(), or a text such as
/// "specification.static_stiffness", preceded by "directions.x." for six directions.
struct YamlStyle {
  std::string head;  ///< comment lines at the top
  /// Returns the text of a number [SI] at a place. The default is the shortest text that is read as the same number.
  std::function<std::string(const std::string& place, double value)> number;
  std::function<std::string(const std::string& place)> note;  ///< returns a comment on the number, or an empty text
};

/// Returns text such as "add[0].stiffness", or "add[0].stiffness[1]" for a number in a list. The index is negative for
/// a number that is not in a list.
std::string numberPlace(const std::string& entry, const std::string& key, int index);

/// Returns YAML from which parseComponentFile() reads the same numbers, bit by bit, unless the style rounds them.
std::string toYaml(const std::vector<ComponentDescription>& components, const YamlStyle& style = {});

}  // namespace rubber_suspension::io
