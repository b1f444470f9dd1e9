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
using Poses = PerBush<Eigen::Isometry3d>;     ///< of body B in body A of each component [m]
using Wrenches = PerBush<component::Wrench>;  ///< to be applied to B to hold the pose, in A's axes [N, N m]

/// front_primary, rear_primary and secondary of half a bogie; front_left, front_right, rear_left and rear_right of a
/// body.
const PerBush<std::string>& bushNames(Kind kind);

/// A component of one direction as one of six whose other directions are free. It acts along the z axis of its frame,
/// which points down, so that its displacement is the compression. `station` is where it is along x [m].
component::SixDirections makeStrut(std::vector<element::ElementDescription> elements, double station);

/// The components of a vehicle. `further` elements are added to each strut, such as a delay. Throws as
/// loadComponentFile and selectComponent do, and ComponentFileError for a component of one direction in place of six.
Bushes loadBushes(Kind kind, const std::string& path, const std::vector<element::ElementDescription>& further = {});

}  // namespace rubber_suspension::vehicle
