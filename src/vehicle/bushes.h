// The rubber components of a vehicle, from a component file, and the poses and wrenches that they exchange with it.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/component/six_directions.h"
#include "vehicle/parameters.h"

namespace rubber_suspension::vehicle {

/// One value for each component, in the order of bushNames().
template <class Value>
using PerBush = std::vector<Value>;

using Bushes = PerBush<component::SixDirections>;
using Poses = PerBush<Eigen::Isometry3d>;     ///< pose of body B in body A for each component [m]
using Wrenches = PerBush<component::Wrench>;  ///< to hold the pose, on body B in A's axes [N, N m]

/// Returns the names of the components: front_primary, rear_primary and secondary for half a bogie, or front_left,
/// front_right, rear_left and rear_right for a body.
const PerBush<std::string>& bushNames(Kind kind);

/// Returns a component of six directions that has elements in the direction z only. The z axis of its frame points
/// down, so that the displacement is the compression. `station` is the position of the component along x [m].
component::SixDirections makeStrut(std::vector<element::ElementDescription> elements, double station);

/// Loads the components of a vehicle. `further` elements, such as a delay, are added to each strut. Throws as
/// loadComponentFile and selectComponent do, and ComponentFileError if a component has one direction where six
/// directions are needed.
Bushes loadBushes(Kind kind, const std::string& path, const std::vector<element::ElementDescription>& further = {});

}  // namespace rubber_suspension::vehicle
