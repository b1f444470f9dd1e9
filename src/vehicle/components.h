// The rubber components of the vehicle from a component file.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/component/component.h"

namespace rubber_suspension::vehicle {

/// The components named as the struts, in their order. `further` elements are added to each, such as a delay.
/// Throws as loadComponentFile and selectComponent do.
std::vector<component::Component> loadStruts(const std::string& path,
                                             const std::vector<element::ElementDescription>& further = {});

}  // namespace rubber_suspension::vehicle
