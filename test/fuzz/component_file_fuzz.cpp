// Fuzz target: any text of a component file is refused with a ComponentFileError, or makes components and reads back
// unchanged after writing.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "rubber_suspension/io/component_file.h"

using rubber_suspension::io::ComponentDescription;
using rubber_suspension::io::SixDirectionsDescription;

namespace {

void require(bool condition, const char* what) {
  if (!condition) {
    std::fprintf(stderr, "violated: %s\n", what);
    std::abort();
  }
}

bool sameElements(const ComponentDescription& a, const ComponentDescription& b);

bool sameDirections(const SixDirectionsDescription& a, const SixDirectionsDescription& b) {
  for (std::size_t i = 0; i < a.directions.size(); ++i) {
    if (a.directions[i].has_value() != b.directions[i].has_value() ||
        (a.directions[i] && !sameElements(*a.directions[i], *b.directions[i]))) {
      return false;
    }
  }
  return a.frame_on_a == b.frame_on_a && a.frame_on_b == b.frame_on_b;
}

bool sameElements(const ComponentDescription& a, const ComponentDescription& b) {
  if (a.six || b.six) {
    return a.six && b.six && sameDirections(*a.six, *b.six);
  }
  const auto of_a = a.allElements();
  const auto of_b = b.allElements();
  if (of_a.size() != of_b.size()) {
    return false;
  }
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    if (of_a[i].type != of_b[i].type || of_a[i].values != of_b[i].values) {
      return false;
    }
  }
  return true;
}

void checkRoundTrip(const std::vector<ComponentDescription>& components) {
  const auto again = rubber_suspension::io::parseComponentFile(rubber_suspension::io::toYaml(components), "written");
  require(again.size() == components.size(), "a written file reads back with as many components");
  for (std::size_t i = 0; i < components.size(); ++i) {
    require(again[i].name == components[i].name, "a written file reads back with the same names");
    require(sameElements(again[i], components[i]), "a written file reads back to the same elements, bit by bit");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<ComponentDescription> components;
  try {
    components = rubber_suspension::io::parseComponentFile(std::string(data, data + size), "fuzz.yaml");
  } catch (const rubber_suspension::io::ComponentFileError& error) {
    require(std::string(error.what()).find('\n') == std::string::npos, "an error is one line");
    return 0;
  }
  for (const ComponentDescription& component : components) {
    if (component.six) {
      component.six->makeComponent();
    } else {
      component.makeComponent();
    }
  }
  checkRoundTrip(components);
  return 0;
}
