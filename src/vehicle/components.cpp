// The rubber components of the vehicle from a component file.
#include "components.h"

#include "half_bogie.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::vehicle {

std::vector<Component> loadStruts(const std::string& path, const std::vector<ElementDescription>& further) {
  const auto file = loadComponentFile(path);
  std::vector<Component> components;
  for (const std::string& name : strutNames()) {
    std::vector<ElementDescription> elements = selectComponent(file, name).allElements();
    elements.insert(elements.end(), further.begin(), further.end());
    components.emplace_back(elements);
  }
  return components;
}

}  // namespace rubber_suspension::vehicle
