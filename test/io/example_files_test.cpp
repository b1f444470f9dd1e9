// All files in config/ are valid, and the example contains every key of a component file.
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/gap/replay.h"
#include "rubber_suspension/io/component_file.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

const std::string kFolder = TEST_DIR "/../config";

// Returns the component itself or, if it has six directions, a component for each direction with a law.
std::vector<io::ComponentDescription> directionsOf(const io::ComponentDescription& component) {
  if (component.six == nullptr) {
    return {component};
  }
  std::vector<io::ComponentDescription> directions;
  for (const auto& direction : component.six->directions) {
    if (direction) {
      directions.push_back(*direction);
    }
  }
  return directions;
}

TEST(ExampleFiles, AllLoadAndGiveFiniteForces) {
  const log::Log sine =
      logOf("sine", 2000, 1000000, [](int i) { return 0.002 * std::sin(2.0 * element::kPi * 4.0 * 1e-3 * i); });
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() != ".yaml") {
      continue;
    }
    ++files;
    for (const io::ComponentDescription& component : io::loadComponentFile(entry.path().string())) {
      for (const io::ComponentDescription& direction : directionsOf(component)) {
        EXPECT_NO_THROW(gap::simulateLog(direction.makeComponent(), sine)) << direction.name;
      }
    }
  }
  EXPECT_GE(files, 2);
}

TEST(ExampleFiles, TheExampleHasEveryModelAndEveryKey) {
  std::set<std::string> models;
  std::set<std::string> keys;
  bool added = false;
  for (const io::ComponentDescription& component : io::loadComponentFile(kFolder + "/example.yaml")) {
    models.insert(estimation::toString(component.model()));
    added = added || !component.add.empty();
    for (const auto& value : component.written().values()) {
      keys.insert(value.first);
    }
  }
  for (int i = static_cast<int>(estimation::Model::kelvin_voigt); i <= static_cast<int>(estimation::Model::elements);
       ++i) {
    EXPECT_EQ(models.count(estimation::toString(static_cast<estimation::Model>(i))), 1u)
        << estimation::toString(static_cast<estimation::Model>(i));
  }
  for (const element::ParameterInfo& parameter : estimation::specificationParameters()) {
    EXPECT_EQ(keys.count(parameter.name), 1u) << parameter.name;
  }
  EXPECT_TRUE(added);
}

}  // namespace
}  // namespace rubber_suspension
