// The component file: YAML that the node and all commands load alike, and write.
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

/// One component as a file describes it. The elements are estimated when the specification is set, which can only be
/// changed as a whole, so that they always belong together.
class ComponentDescription {
 public:
  /// Makes a component of the model `elements` without any.
  ComponentDescription() = default;

  /// Makes a component of the model `elements`.
  ComponentDescription(std::string component, std::vector<element::ElementDescription> list)
      : name(std::move(component)), elements_(std::move(list)) {}

  /// Makes a component of any other model, with added elements. Throws std::invalid_argument if the specification has
  /// no solution.
  ComponentDescription(std::string component, estimation::Model model, estimation::Specification specification,
                       std::vector<element::ElementDescription> added = {});

  std::string name;                              ///< a ROS base name
  std::vector<element::ElementDescription> add;  ///< effects on top
  std::optional<RigTolerances> rig;              ///< tolerances of the rig that measures it, where given
  /// A wlf_shift or arrhenius_shift: how it follows a temperature, where given.
  std::optional<element::ElementDescription> temperature;
  std::optional<element::Range> valid_displacement;  ///< where the component is valid [m], where given
  std::vector<std::string> excluded_effects;  ///< that its construction rules out, which a diagnosis knows by name
  /// Tolerance of the values of `elements`; that of an entry, such as "spring[0]", comes first.
  estimation::SheetTolerance tolerance;
  bool holds_fluid = false;  ///< a resonance in its force is then that of the fluid, not of the fixture
  /// Units of the numbers in its file, by the SI unit; of several the first.
  std::map<std::string, std::string> units;
  /// Set for a component of six directions, which has only a name besides; otherwise nullptr.
  std::shared_ptr<const SixDirectionsDescription> six;

  estimation::Model model() const { return model_; }

  /// Specification of the base, whatever the file describes: estimate() makes elements() of it. Empty for the model
  /// `elements`.
  const estimation::Specification& specification() const { return resolved_.specification; }

  /// Specification as given, such as that of the whole component, or points.
  const estimation::Specification& written() const { return written_; }

  /// Findings on the way from written() to specification(): notes, misfits of points.
  const estimation::Resolved& resolved() const { return resolved_; }

  /// Elements that the model estimates from the specification, or lists, without added ones.
  const std::vector<element::ElementDescription>& elements() const { return elements_; }

  /// Sets another specification of the model, of the base or of the whole with the present added elements. Throws
  /// std::invalid_argument, without any change, if that has no solution; std::logic_error for the model `elements`,
  /// which has none.
  void specify(estimation::Specification specification);

  /// The elements of the model, those added, and the shift with temperature. Throws std::invalid_argument for a
  /// component of six directions.
  std::vector<element::ElementDescription> allElements() const;

  /// The component without what belongs to the rig that measured it (element::isOfRig()), of any number of directions.
  ComponentDescription withoutRig() const;

  /// Displacements [m] beyond which its forces are no more than an extrapolation: `valid_displacement`, else
  /// what its tables of springs have in common, else nothing.
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
  /// Each as a component of one direction, named after both, rotations in rad and N m; nothing where it is free.
  std::array<std::optional<ComponentDescription>, component::kDirections> directions;
  std::array<std::optional<component::Preload>, component::kDirections> preload;
  std::vector<component::PreloadTable> tables;
  component::SixDirectionsLaws arrangement;  ///< without elements: couplings, measure, frames
  /// Where the bush sits on the bodies, as arrangement has it, in numbers: position [m], rotation in its measure [rad].
  component::SixNumbers frame_on_a = component::SixNumbers::Zero();
  component::SixNumbers frame_on_b = component::SixNumbers::Zero();

  /// The factor on the forces of a direction by the tables. Throws std::invalid_argument where a preload is missing.
  double factorOf(component::Direction direction) const;

  /// Throws std::invalid_argument that begins with the direction, where its elements cannot be coupled or scaled.
  component::SixDirections makeComponent() const;
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

/// Loads and check everything, estimation included. Numbers are SI, text carries its unit. Refused are unknown, missing
/// and repeated keys, wrong types, units of another dimension, values out of range or not finite, names that are no ROS
/// base name, and specifications without solution. Throws ComponentFileError.
std::vector<ComponentDescription> loadComponentFile(const std::string& path);

/// Parses a component file from text; `source` stands for the file's name in errors.
std::vector<ComponentDescription> parseComponentFile(const std::string& text, const std::string& source);

/// The component of that name; with an empty name the only one. Throws ComponentFileError that lists the names and
/// begins with `source`, the file's name, if given.
const ComponentDescription& selectComponent(const std::vector<ComponentDescription>& components,
                                            const std::string& name, const std::string& source = "");

/// Format of numbers for people; a place is that of numberPlace(), or "specification.static_stiffness", for six
/// directions behind "directions.x.".
struct YamlStyle {
  std::string head;  ///< lines of comment before all
  /// The text of a number [SI] at a place; where not given, the shortest that reads back as the same number.
  std::function<std::string(const std::string& place, double value)> number;
  std::function<std::string(const std::string& place)> note;  ///< a comment on it; may be empty
};

/// "add[0].stiffness", or "add[0].stiffness[1]" in a list; an index below 0: no list.
std::string numberPlace(const std::string& entry, const std::string& key, int index);

/// Returns YAML that parseComponentFile reads back to the same numbers, bit by bit, unless the style rounds.
std::string toYaml(const std::vector<ComponentDescription>& components, const YamlStyle& style = {});

}  // namespace rubber_suspension::io
