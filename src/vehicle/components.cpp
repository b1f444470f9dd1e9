// The rubber components of the vehicle from a component file.
#include "vehicle/components.h"

#include <fmt/format.h>

#include "element/refuse.h"
#include "rubber_suspension/io/component_file.h"
#include "vehicle/parameters.h"

namespace rubber_suspension::vehicle {

std::vector<component::Component> loadStruts(const std::string& path,
                                             const std::vector<element::ElementDescription>& further) {
  const auto file = io::loadComponentFile(path);
  std::vector<component::Component> components;
  for (const std::string& name : strutNames()) {
    std::vector<element::ElementDescription> elements =
        io::selectComponent(file, name, path).withoutRig().allElements();
    elements.insert(elements.end(), further.begin(), further.end());
    components.emplace_back(elements);
  }
  return components;
}

PerBush<component::SixDirections> loadBushes(BushedKind kind, const std::string& path) {
  const auto file = io::loadComponentFile(path);
  PerBush<component::SixDirections> components;
  for (const std::string& name : bushNames(kind)) {
    const io::ComponentDescription description = io::selectComponent(file, name, path).withoutRig();
    element::refuseIf<io::ComponentFileError>(
        !description.six, "{}: component {} has one direction; accepted: six, with the key `directions`", path, name);
    components.push_back(description.six->makeComponent());
  }
  return components;
}

}  // namespace rubber_suspension::vehicle
