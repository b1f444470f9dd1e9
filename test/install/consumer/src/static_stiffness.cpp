// Loads a component file, and prints the static stiffness of each component after a hold of an hour.
// Usage: static_stiffness COMPONENTS.yaml
#include <cstdio>
#include <exception>

#include "rubber_suspension/io/component_file.h"

namespace {

/// Returns the force divided by the displacement [N/m] after a slow move to 1 mm and an hour at rest.
double staticStiffness(const rubber_suspension::component::Component& component) {
  constexpr double kDisplacement = 1e-3;  // [m]
  constexpr double kHour = 3600.0;        // [s]
  rubber_suspension::component::ComponentState state = component.makeState();
  const double before = component.initialise(state, 0.0).total;
  component.step(state, kHour, kDisplacement);
  return (component.step(state, kHour, kDisplacement).total - before) / kDisplacement;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: static_stiffness COMPONENTS.yaml\n");
    return 2;
  }
  try {
    for (const auto& description : rubber_suspension::io::loadComponentFile(argv[1])) {
      std::printf("%s %.6g N/m\n", description.name.c_str(), staticStiffness(description.makeComponent()));
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "static_stiffness: %s\n", error.what());
    return 1;
  }
  return 0;
}
