// What everything about the vehicle knows of it.
#include "vehicle/parameters.h"

namespace rubber_suspension::vehicle {

const std::array<std::string, kStruts>& strutNames() {
  static const std::array<std::string, kStruts> names = {"front_primary", "rear_primary", "secondary"};
  return names;
}

}  // namespace rubber_suspension::vehicle
