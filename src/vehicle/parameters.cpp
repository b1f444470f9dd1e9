// The data of the vehicle.
#include "vehicle/parameters.h"

namespace rubber_suspension::vehicle {

const std::array<std::string, kStruts>& strutNames() {
  static const std::array<std::string, kStruts> names = {"front_primary", "rear_primary", "secondary"};
  return names;
}

const std::vector<std::string>& bushNames(BushedKind kind) {
  static const std::vector<std::string> body = {"front_left", "front_right", "rear_left", "rear_right"};
  static const std::vector<std::string> half_bogie(strutNames().begin(), strutNames().end());
  return kind == BushedKind::body ? body : half_bogie;
}

}  // namespace rubber_suspension::vehicle
