// Descriptions of components, independent of a file.
#include <fmt/format.h>

#include <algorithm>

#include "element/suggestion.h"
#include "log/text.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::io {
namespace {

// Returns a preload as a force or as a displacement. If necessary, the static curve converts one to the other.
double preloadAs(bool force, const SixDirectionsDescription& six, component::Direction direction) {
  const std::optional<component::Preload>& preload = six.preload[direction];
  if (!preload || !six.directions[direction]) {
    throw std::invalid_argument(fmt::format("needs the preload of {}, which is missing; accepted: the key preload.{}",
                                            toString(direction), toString(direction)));
  }
  if (preload->is_force == force) {
    return preload->value;
  }
  const estimation::StaticCurve* curve = six.directions[direction]->written().curve();
  if (curve == nullptr) {
    throw std::invalid_argument(
        fmt::format("is a table over a {}, but preload.{} is a {} and {} has no static_curve; accepted: a {}",
                    force ? "force" : "displacement", toString(direction), force ? "displacement" : "force",
                    toString(direction), force ? "table over displacements" : "table over forces"));
  }
  return force ? curve->forceAt(preload->value) : curve->displacementAt(preload->value);
}

std::vector<element::ElementDescription> ofRubber(std::vector<element::ElementDescription> elements) {
  elements.erase(std::remove_if(elements.begin(), elements.end(), element::isOfRig), elements.end());
  return elements;
}

}  // namespace

ComponentFileError::ComponentFileError(const std::string& message) : std::runtime_error(log::oneLine(message)) {}

ComponentDescription::ComponentDescription(std::string component, estimation::Model model,
                                           estimation::Specification specification,
                                           std::vector<element::ElementDescription> added)
    : name(std::move(component)), add(std::move(added)), model_(model) {
  specify(std::move(specification));
}

void ComponentDescription::specify(estimation::Specification specification) {
  if (model_ == estimation::Model::elements) {
    throw std::logic_error("the model elements has no specification");
  }
  estimation::Resolved resolved = estimation::resolve(model_, specification, ofRubber(add));
  elements_ = estimation::estimate(model_, resolved.specification);
  resolved_ = std::move(resolved);
  written_ = std::move(specification);
}

ComponentDescription ComponentDescription::withoutRig() const {
  ComponentDescription result = *this;
  result.elements_ = ofRubber(elements_);
  result.add = ofRubber(add);
  if (six) {
    auto directions = std::make_shared<SixDirectionsDescription>(*six);
    for (std::optional<ComponentDescription>& direction : directions->directions) {
      direction = direction ? std::optional(direction->withoutRig()) : std::nullopt;
    }
    result.six = std::move(directions);
  }
  return result;
}

std::vector<element::ElementDescription> ComponentDescription::allElements() const {
  if (six) {
    throw std::invalid_argument(
        fmt::format("component '{}' has six directions; accepted: a component of one direction", name));
  }
  std::vector<element::ElementDescription> all = elements_;
  all.insert(all.end(), add.begin(), add.end());
  if (temperature) {
    all.push_back(*temperature);
  }
  return all;
}

std::optional<element::Range> ComponentDescription::validDisplacement() const {
  if (valid_displacement || six) {
    return valid_displacement;
  }
  std::optional<element::Range> common;
  for (const element::ElementDescription& element : allElements()) {
    if (element.type == "spring_table") {
      const std::vector<double>& displacement = element.values.at("displacement");
      const auto ends = element::Range::closed(displacement.front(), displacement.back());
      common = common ? element::intersection(*common, ends) : ends;
    }
  }
  return common;
}

double SixDirectionsDescription::factorOf(component::Direction direction) const {
  double factor = 1.0;
  for (const component::PreloadTable& table : tables) {
    if (table.direction == direction) {
      factor *= table.factorAt(preloadAs(table.preload.front().is_force, *this, table.by));
    }
  }
  return factor;
}

component::SixDirections SixDirectionsDescription::makeComponent() const {
  component::SixDirectionsLaws laws = arrangement;
  for (std::size_t i = 0; i < component::kDirections; ++i) {
    if (directions[i]) {
      laws.elements[i] = directions[i]->allElements();
      const double factor = factorOf(static_cast<component::Direction>(i));
      if (factor != 1.0) {
        component::scaleForces(laws.elements[i], factor);
      }
    }
  }
  return component::SixDirections(std::move(laws));
}

const ComponentDescription& selectComponent(const std::vector<ComponentDescription>& components,
                                            const std::string& name, const std::string& source) {
  if (name.empty() && components.size() == 1) {
    return components.front();
  }
  std::vector<std::string> names;
  for (const ComponentDescription& component : components) {
    if (component.name == name) {
      return component;
    }
    names.push_back(component.name);
  }
  const std::string problem =
      name.empty() ? "there is more than one component; accepted: the name of one of "
                   : fmt::format("there is no component '{}'{}; accepted: ", name, element::didYouMean(name, names));
  throw ComponentFileError((source.empty() ? "" : source + ": ") + problem + log::join(names));
}

}  // namespace rubber_suspension::io
