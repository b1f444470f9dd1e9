// The rubber components of the vehicle from a component file.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/component/six_directions.h"
#include "vehicle/parameters.h"

namespace rubber_suspension::vehicle {

/// The components named as the struts, in their order. `further` elements are added to each, such as a delay.
/// Throws as loadComponentFile and selectComponent do.
std::vector<component::Component> loadStruts(const std::string& path,
                                             const std::vector<element::ElementDescription>& further = {});

/// The components of six directions of a vehicle, in their order. Throws ComponentFileError, also for one of one
/// direction.
PerBush<component::SixDirections> loadBushes(BushedKind kind, const std::string& path);

}  // namespace rubber_suspension::vehicle
