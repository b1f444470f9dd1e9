// Component files of six directions: accepted keys, refusals, and reading back what was written.
#include "rubber_suspension/io/component_file.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

std::string file(const std::string& body) { return "components:\n  bush:\n" + body; }

const std::string kBush = R"(    directions:
      x: &radial
        model: multi_maxwell
        specification:
          describes: base
          static_curve: {displacement: [-2 mm, -1 mm, 0, 1 mm, 2 mm], force: [-5 kN, -2 kN, 0, 2 kN, 5 kN]}
          dynamic_stiffness: 3 kN/mm
          nominal_frequency: 5 Hz
          maximum_stiffness: 4 kN/mm
          high_frequency: 20 Hz
        add: [{type: iwan, maximum_force: 200 N, displacement: 0.3 mm}]
      y: *radial
      z: {model: elements, elements: [{type: spring, stiffness: 1 kN/mm}], valid_displacement: 8 mm}
      rx: &tilt {model: elements, elements: [{type: spring, stiffness: 15.707963267948966 N m/deg}]}
      ry: *tilt
      rz:
        model: maxwell
        specification: {static_stiffness: 250 N m/rad, dynamic_stiffness: 300 N m/rad, nominal_frequency: 5, maximum_stiffness: 400}
    coupling: {translation: cylindrical, rotation: rectangular, axis: z}
    rotation: cardan
    valid_rotation: 40 deg
    excluded_effects: [free_play]
    holds_fluid: true
    frame:
      a: {position: [10 cm, 0, -5 mm], rotation: [0, 90 deg, 0]}
      b: {position: [0, 0, 0.2]}
    preload: {z: 5 kN}
    stiffness_by_preload:
      - {direction: rx, by: z, preload: [0 N, 10 kN], factor: [1.0, 1.5]}
)";

std::string refusal(const std::string& text) {
  return messageOf<io::ComponentFileError>([&] { io::parseComponentFile(text, "bush.yaml"); });
}

std::string replaced(const std::string& part, const std::string& by) {
  std::string text = file(kBush);
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.replace(at, part.size(), by);
}

TEST(SixDirectionsFile, LoadsAll) {
  const auto components = io::parseComponentFile(file(kBush), "bush.yaml");
  const io::ComponentDescription& description = io::selectComponent(components, "bush");
  ASSERT_NE(description.six, nullptr);
  const io::SixDirectionsDescription& six = *description.six;
  EXPECT_EQ(six.directions[component::kX]->name, "bush_x");
  EXPECT_EQ(six.directions[component::kRz]->excluded_effects, std::vector<std::string>{"free_play"});
  EXPECT_TRUE(six.directions[component::kRz]->holds_fluid);
  EXPECT_NEAR(six.directions[component::kRx]->elements()[0].value("stiffness"), 900.0, 1e-9);
  EXPECT_EQ(six.arrangement.translation, component::Coupling::cylindrical);
  EXPECT_EQ(six.arrangement.rotation, component::Coupling::rectangular);
  EXPECT_EQ(six.arrangement.measure, component::RotationMeasure::cardan);
  EXPECT_NEAR(six.arrangement.valid_rotation, 0.6981317007977318, 1e-15);
  EXPECT_LT((six.arrangement.on_a.linear() * Eigen::Vector3d::UnitX() + Eigen::Vector3d::UnitZ()).norm(), 1e-15);
  EXPECT_EQ(six.arrangement.on_b.translation().z(), 0.2);
  EXPECT_EQ(six.factorOf(component::kRx), 1.25);
  EXPECT_EQ(six.factorOf(component::kRy), 1.0);
  const component::SixDirections bush = six.makeComponent();
  EXPECT_NEAR(bush.laws().elements[component::kRx][0].value("stiffness"), 1125.0, 1e-9);
  // Code for a single direction must not mistake the description for a component without elements.
  EXPECT_THROW(description.makeComponent(), std::invalid_argument);
}

TEST(SixDirectionsFile, ReadsBackWhatItWrites) {
  const std::string text = io::toYaml(io::parseComponentFile(file(kBush), "bush.yaml"));
  EXPECT_EQ(io::toYaml(io::parseComponentFile(text, "again.yaml")), text);
  EXPECT_NE(text.find("# [N m/rad]"), std::string::npos);
}

// The preload is the operating point on the static curve, whose tangent is 3 kN/mm at 1.5 mm and 2 kN/mm at 0.5 mm.
TEST(SixDirectionsFile, PreloadsTheSpecification) {
  const std::string curve =
      "    directions: {z: {model: kelvin_voigt, specification: {static_curve: {displacement: [0, 1 mm, 2 mm], force: "
      "[0, 2 kN, 5 kN]}, nominal_frequency: 5, relative_damping: 5 %}}}\n";
  const auto damping = [&](const std::string& preload) {
    const auto components = io::parseComponentFile(file(curve + preload), "bush.yaml");
    return components[0].six->directions[component::kZ]->elements()[1].list("damping")[0];
  };
  const double loose = damping("    preload: {z: 0.5 mm}\n");
  EXPECT_NEAR(damping("    preload: {z: 3.5 kN}\n"), damping("    preload: {z: 1.5 mm}\n"), 1e-12 * loose);
  EXPECT_EQ(damping("    preload: {z: 1 kN}\n"), loose);
}

TEST(SixDirectionsFile, ErrorsNameDirectionAndKey) {
  const std::string bush = "component 'bush': ";
  const auto expect = [](const std::string& text, const std::string& begin, const std::string& part) {
    const std::string message = refusal(text);
    EXPECT_EQ(message.rfind("bush.yaml:", 0), 0U) << message;
    EXPECT_NE(message.find("component 'bush': " + begin), std::string::npos) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_NE(message.find("accepted: "), std::string::npos) << message;
  };
  expect(replaced("15.707963267948966 N m/deg", "3 kN/mm"), "directions.rx.elements[0].stiffness", "in N m/rad");
  expect(replaced("static_stiffness: 250 N m/rad", "static_stiffness: 250 N/m"),
         "directions.rz.specification.static_stiffness", "in N m/rad");
  expect(replaced("dynamic_stiffness: 300 N m/rad", "dynamic_stiffness: 200 N m/rad"), "directions.rz: specification.",
         "N m/rad");
  expect(replaced("stiffness: 1 kN/mm", "stifness: 1 kN/mm"), "directions.z.elements[0].stifness", "did you mean");
  expect(replaced("      rz:\n", "      r_z:\n"), "directions.r_z", "rz");
  expect(replaced("cylindrical", "cilindrical"), "coupling.translation", "cylindrical");
  expect(replaced("axis: z", "axis: w"), "coupling.axis", "x or y or z");
  expect(replaced("rotation: cardan", "rotation: euler"), "rotation", "vector or cardan");
  expect(replaced("valid_rotation: 40 deg", "valid_rotation: 86 deg"), "valid_rotation", "out of range");
  expect(replaced("[0, 90 deg, 0]", "[0, 90 deg]"), "frame.a.rotation", "a list of three");
  expect(replaced("preload: {z: 5 kN}", "preload: {z: 5}"), "preload.z", "with a unit");
  expect(replaced("preload: {z: 5 kN}", "preload: {z: 5 Hz}"), "preload.z", "Hz");
  expect(replaced("by: z, preload: [0 N, 10 kN]", "by: z, preload: [0 mm, 1 mm]"), "stiffness_by_preload[0]",
         "static_curve");
  expect(replaced("by: z, preload: [0 N, 10 kN]", "by: y, preload: [0 N, 10 kN]"), "stiffness_by_preload[0]",
         "preload.y");
  expect(replaced("factor: [1.0, 1.5]", "factor: [1.0, 1.5], instantaneous: true"),
         "stiffness_by_preload[0].instantaneous", "closed loops");
  expect(replaced("type: iwan", "type: friction"), "directions.x: friction (Berg)", "type: iwan");
  expect(replaced("[-5 kN, -2 kN, 0, 2 kN, 5 kN]", "[-6 kN, -2 kN, 0, 2 kN, 5 kN]"), "directions.x: the static curve",
         "odd");
  expect(file("    directions: {}\n"), "directions", "x, y, z");
  expect(file("    directions: {x: 3}\n"), "directions.x", "free");
  expect(
      file("    directions: {x: {model: elements, elements: [{type: spring, stiffness: 1}]}}\n    preload: {y: 1 N}\n"),
      "preload.y", "free");
}

}  // namespace
}  // namespace rubber_suspension
