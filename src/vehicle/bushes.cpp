// The rubber components of a vehicle.
#include "vehicle/bushes.h"

#include "element/refuse.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::vehicle {

const PerBush<std::string>& bushNames(Kind kind) {
  static const PerBush<std::string> body = {"front_left", "front_right", "rear_left", "rear_right"};
  static const PerBush<std::string> half_bogie = {"front_primary", "rear_primary", "secondary"};
  return kind == Kind::body ? body : half_bogie;
}

component::SixDirections makeStrut(std::vector<element::ElementDescription> elements, double station) {
  component::SixDirectionsLaws laws;
  laws.elements[component::kZ] = std::move(elements);
  for (Eigen::Isometry3d* frame : {&laws.on_a, &laws.on_b}) {
    frame->translation().x() = station;
    frame->linear() = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  }
  return component::SixDirections(laws);
}

Bushes loadBushes(Kind kind, const std::string& path, const std::vector<element::ElementDescription>& further) {
  const double front = VehicleParameters().semi_wheelbase;
  const std::array<double, 3> stations = {front, -front, 0.0};  // positions of the struts along x [m]
  const auto file = io::loadComponentFile(path);
  Bushes bushes;
  for (const std::string& name : bushNames(kind)) {
    const io::ComponentDescription description = io::selectComponent(file, name, path).withoutRig();
    if (kind == Kind::struts) {
      std::vector<element::ElementDescription> elements = description.allElements();
      elements.insert(elements.end(), further.begin(), further.end());
      bushes.push_back(makeStrut(elements, stations[bushes.size()]));
      continue;
    }
    element::refuseIf<io::ComponentFileError>(
        !description.six, "{}: component {} has one direction; accepted: six directions, with the key `directions`",
        path, name);
    bushes.push_back(description.six->makeComponent());
  }
  return bushes;
}

}  // namespace rubber_suspension::vehicle
