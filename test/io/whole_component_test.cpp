// Specifications of whole components, static curves, preloads and operating points in component files, and merge keys.
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/gap/replay.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/response/sweep.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

io::ComponentDescription load(const std::string& content) {
  return componentOf("components:\n  bush:\n" + content, "file.yaml");
}

std::string refusalOf(const std::string& content) {
  return messageOf<io::ComponentFileError>([&] { load(content); });
}

response::Characteristics at(const io::ComponentDescription& component, double frequency, double amplitude,
                             double mean) {
  response::LoopOptions options;
  options.mean = mean;
  return response::characteristicsAt(component.makeComponent(), frequency, amplitude, options).characteristics;
}

std::vector<double> forcesOf(const io::ComponentDescription& component) {
  const log::Log sines = logOf("sines", 3000, 1000000, [](int i) {
    return 0.002 * std::sin(2.0 * element::kPi * 4.0e-3 * i) + 1e-3 * std::sin(0.07 * i);
  });
  return gap::simulateLog(component.makeComponent(), sines);
}

const char* const kWhole = R"(    model: multi_maxwell
    specification:
      describes: component
      static_stiffness: 3 kN/mm
      dynamic_stiffness: 5 kN/mm
      nominal_frequency: 4
      nominal_amplitude: 2 mm
      maximum_stiffness: 4.9 kN/mm
      high_frequency: 25
    add:
      - {type: friction, maximum_force: 6 kN, displacement: 2.2 mm}
)";

const char* const kOnARig = R"(    model: elements
    elements:
      - {type: spring, stiffness: 3 kN/mm}
    add:
      - {type: inertia, mass: 10, of_rig: true}
      - {type: inertia, mass: 2}
      - {type: time_delay, delay: 1 ms}
)";

TEST(OfRig, IsKeptAndLeftOut) {
  const io::ComponentDescription component = load(kOnARig);
  EXPECT_TRUE(element::isOfRig(component.add[0]));
  EXPECT_FALSE(element::isOfRig(component.add[1]));
  EXPECT_TRUE(element::isOfRig(component.add[2])) << "a measuring chain is never of the rubber";
  EXPECT_EQ(io::parseComponentFile(io::toYaml({component}), "written").front().add, component.add);
  EXPECT_THAT(io::toYaml({component}), HasSubstr("{type: time_delay, delay: 0.001, of_rig: true}"));
  const io::ComponentDescription rubber = component.withoutRig();
  ASSERT_EQ(rubber.add.size(), 1U);
  EXPECT_EQ(rubber.add[0].value("mass"), 2.0);
  EXPECT_EQ(rubber.elements(), component.elements());
}

TEST(OfRig, IsRefusedInOneLine) {
  EXPECT_THAT(refusalOf(std::string(kOnARig) + "      - {type: sensor_gain, gain: 1.02, of_rig: false}\n"),
              HasSubstr("of_rig: is false, but this element describes the measuring chain"));
  EXPECT_THAT(
      refusalOf(std::string(kOnARig) + "      - {type: friction, of_rig: 3, maximum_force: 1, displacement: 1}\n"),
      HasSubstr("of_rig: '3'; accepted: false or true"));
}

// The data sheet describes the rubber alone, without the elements of the rig.
TEST(OfRig, IsNoPartOfTheWholeThatASheetDescribes) {
  const io::ComponentDescription alone = load(kWhole);
  const io::ComponentDescription on_a_rig = load(
      std::string(kWhole) + "      - {type: coulomb_friction, maximum_force: 1 kN, stiffness: 1e7, of_rig: true}\n");
  EXPECT_EQ(on_a_rig.elements(), alone.elements());
}

// The written file has base values that estimate the same elements, so forces agree to 1e-9.
TEST(WholeComponentFile, IsWrittenAsABase) {
  const io::ComponentDescription whole = load(kWhole);
  EXPECT_EQ(whole.written().at("dynamic_stiffness"), 5e6);
  EXPECT_LT(whole.specification().at("dynamic_stiffness"), 4.9e6);
  EXPECT_NEAR(at(whole, 4.0, 2e-3, 0.0).stiffness, 5e6, 5.0);
  const std::string text = io::toYaml({whole});
  EXPECT_THAT(text, HasSubstr("describes: base"));
  const io::ComponentDescription base = io::parseComponentFile(text, "base.yaml").at(0);
  const std::vector<double> of_whole = forcesOf(whole);
  const std::vector<double> of_base = forcesOf(base);
  for (std::size_t i = 0; i < of_whole.size(); ++i) {
    ASSERT_NEAR(of_base[i], of_whole[i], 1e-9 * 1e4);
  }
  EXPECT_EQ(io::toYaml({base}), text);
}

TEST(WholeComponentFile, WithoutASolutionNamesItInTheUnitsOfTheUser) {
  std::string content = kWhole;
  content.replace(content.find("5 kN/mm"), 7, "4.2 kN/mm");
  const std::string refusal = refusalOf(content);
  EXPECT_THAT(refusal,
              HasSubstr("file.yaml:7: component 'bush': specification.dynamic_stiffness: 4.2 kN/mm cannot be"));
  EXPECT_THAT(refusal, HasSubstr("dynamic_stiffness in (4.33623, 6.08374) kN/mm"));
  // The error proposes the nearest specification with a solution, which can be pasted into the file.
  const std::string nearest = "nearest: specification: {";
  const std::size_t begin = refusal.find(nearest) + nearest.size();
  const std::string pasted = refusal.substr(begin, refusal.find('}', begin) - begin);
  const io::ComponentDescription component =
      load("    model: multi_maxwell\n    specification: {describes: component, " + pasted +
           "}\n    add:\n      - {type: friction, maximum_force: 6 kN, displacement: 2.2 mm}\n");
  EXPECT_NEAR(at(component, 4.0, 2e-3, 0.0).stiffness, component.written().at("dynamic_stiffness"), 5.0);
}

const char* const kCurve = R"(      static_curve:
        displacement: [0 mm, 5 mm, 10 mm, 15 mm, 20 mm, 25 mm]
        force: [0 kN, 5 kN, 11 kN, 19 kN, 30 kN, 45 kN]
)";

// The curve is the absolute static force. K_st is the tangent at the nominal force, or the mean of both at a point.
TEST(StaticCurveFile, IsTheForceAtRest) {
  const io::ComponentDescription component =
      load(std::string("    model: maxwell\n    specification:\n") + kCurve +
           "      nominal_force: 19 kN\n      dynamic_stiffness: 2.4 kN/mm\n      nominal_frequency: 10\n"
           "      break_frequency: 5\n");
  const component::Component built = component.makeComponent();
  component::ComponentState state = built.makeState();
  EXPECT_NEAR(built.initialise(state, 7.5e-3).total, 8e3, 1e-9);
  EXPECT_NEAR(built.initialise(state, 30e-3).total, 60e3, 1e-9) << "along the last slope";
  EXPECT_NEAR(estimation::estimateTangent(component.model(), component.specification())[0].value("stiffness"), 1.9e6,
              1e-3);
  EXPECT_THAT(io::toYaml({component}), HasSubstr("scale_with: static_curve"));
  EXPECT_EQ(io::toYaml(io::parseComponentFile(io::toYaml({component}), "again.yaml")), io::toYaml({component}));
}

// For small oscillations about any preload, stiffness is proportional to the tangent and the loss angle is constant.
TEST(StaticCurveFile, KeepsTheLossAngleUnderPreload) {
  const io::ComponentDescription component =
      load(std::string("    model: maxwell\n    specification:\n") + kCurve +
           "      nominal_displacement: 2.5 mm\n      dynamic_stiffness: 1.3 kN/mm\n      nominal_frequency: 10\n"
           "      break_frequency: 5\n");
  const response::Characteristics nominal = at(component, 10.0, 1e-4, 2.5e-3);
  EXPECT_NEAR(nominal.stiffness, 1.3e6, 10.0);
  for (const auto& [mean, slope] : {std::pair(7.5e-3, 1.2), std::pair(12.5e-3, 1.6), std::pair(22.5e-3, 3.0)}) {
    const response::Characteristics found = at(component, 10.0, 1e-4, mean);
    EXPECT_NEAR(found.loss_angle, nominal.loss_angle, 1e-3 * nominal.loss_angle) << mean;
    EXPECT_NEAR(found.stiffness / nominal.stiffness, slope, 1e-4) << mean;
  }
}

// Degressive and falling curves are accepted as springs. Elements scaled along a falling curve would create energy.
TEST(StaticCurveFile, MayFallWhereNothingScales) {
  const std::string falling =
      "    model: maxwell\n    specification:\n      static_curve: {displacement: [-0.01, 0.0, 0.01, 0.02], force: "
      "[-5e3, 100.0, 5e3, 4e3]}\n      nominal_displacement: 5 mm\n      dynamic_stiffness: 0.7 kN/mm\n"
      "      nominal_frequency: 10\n      break_frequency: 5\n";
  EXPECT_THAT(refusalOf(falling),
              HasSubstr("the force falls from 0.01 m to 0.02 m, and elements that scale with the curve"));
  EXPECT_EQ(refusalOf(falling + "      scale_with: none\n"), "");
  EXPECT_THAT(refusalOf(falling + "      static_stiffness: 3e6\n      scale_with: none\n"),
              HasSubstr("static_stiffness: is given together with static_curve"));
  EXPECT_THAT(refusalOf(falling + "      scale_with: curve\n"), HasSubstr("accepted: static_curve or none"));
}

TEST(StaticCurveFile, ScalesSlidersWhereAsked) {
  const std::string start = std::string("    model: maxwell\n    specification:\n") + kCurve +
                            "      nominal_displacement: 2.5 mm\n      dynamic_stiffness: 1.3 kN/mm\n"
                            "      nominal_frequency: 10\n      break_frequency: 5\n    add:\n      - ";
  const io::ComponentDescription component =
      load(start + "{type: coulomb_friction, maximum_force: 100, stiffness: 1e6, scale_with: static_curve}\n");
  ASSERT_EQ(component.add.size(), 1u);
  EXPECT_EQ(component.add[0].type, "sliders_along_curve");
  EXPECT_THAT(refusalOf(start + "{type: friction, maximum_force: 100, displacement: 1e-3, scale_with: static_curve}\n"),
              HasSubstr("friction.scale_with: this element cannot scale with a curve"));
}

// Each block of the data sheet has its own preload and stiffness. Between the preloads, the stiffness is in between.
TEST(PreloadsFile, MeetEachBlock) {
  const io::ComponentDescription component =
      load(std::string("    model: multi_maxwell\n    specification:\n") + kCurve +
           "      nominal_frequency: 10\n      high_frequency: 60\n      low_frequency: 0.5\n      preloads:\n"
           "        - {nominal_displacement: 2.5 mm, dynamic_stiffness: 1.3 kN/mm, maximum_stiffness: 1.6 kN/mm}\n"
           "        - {nominal_displacement: 17.5 mm, dynamic_stiffness: 3.3 kN/mm, maximum_stiffness: 4.4 kN/mm}\n");
  // About a preload, the stiffness of the branches changes as an odd function, so a small loop has the value there.
  EXPECT_NEAR(at(component, 10.0, 1e-5, 2.5e-3).stiffness, 1.3e6, 1.3e3);
  EXPECT_NEAR(at(component, 10.0, 1e-5, 17.5e-3).stiffness, 3.3e6, 3.3e3);
  const double between = at(component, 10.0, 1e-5, 12.5e-3).stiffness;
  EXPECT_GT(between, 1.6e6);
  EXPECT_LT(between, 3.3e6);
  EXPECT_EQ(io::toYaml(io::parseComponentFile(io::toYaml({component}), "again.yaml")), io::toYaml({component}));
}

TEST(PreloadsFile, ShareTheirBreakFrequencies) {
  EXPECT_THAT(refusalOf(std::string("    model: maxwell\n    specification:\n") + kCurve +
                        "      nominal_frequency: 10\n      preloads:\n"
                        "        - {nominal_displacement: 2.5 mm, dynamic_stiffness: 1.3 kN/mm, loss_angle: 6 deg}\n"
                        "        - {nominal_displacement: 17.5 mm, dynamic_stiffness: 3 kN/mm, loss_angle: 9 deg}\n"),
              HasSubstr("break frequencies of the blocks differ"));
}

TEST(PointsFile, BecomeABase) {
  const io::ComponentDescription component = load(R"(    model: maxwell
    specification:
      points:
        - {frequency: 1 Hz, stiffness: 2.1 kN/mm, loss_angle: 3 deg}
        - {frequency: 10 Hz, stiffness: 2.5 kN/mm, loss_angle: 6 deg, weight: 2}
        - {frequency: 40 Hz, stiffness: 2.8 kN/mm}
)");
  EXPECT_EQ(component.resolved().points.size(), 3u);
  EXPECT_TRUE(component.specification().has("break_frequency"));
  EXPECT_THAT(io::toYaml({component}), HasSubstr("describes: base"));
  EXPECT_THAT(refusalOf("    model: maxwell\n    specification: {points: [{frequency: 1, stifness: 2e6}]}\n"),
              HasSubstr("did you mean 'stiffness'"));
}

TEST(MergeKeys, TakeWhatTheMapDoesNotHave) {
  const io::ComponentDescription component = load(R"(    model: elements
    elements:
      - &spring {type: spring, stiffness: 1 kN/mm}
      - {<<: *spring, stiffness: 2 kN/mm}
      - {<<: [*spring]}
)");
  ASSERT_EQ(component.elements().size(), 3u);
  EXPECT_EQ(component.elements()[1].value("stiffness"), 2e6);
  EXPECT_EQ(component.elements()[2].value("stiffness"), 1e6);
  EXPECT_THAT(refusalOf("    model: elements\n    elements:\n      - {<<: 3, type: spring, stiffness: 1e6}\n"),
              HasSubstr("accepted: an anchor of another map"));
  EXPECT_NE(refusalOf("    model: elements\n    elements:\n      - &a {<<: *a, type: spring, stiffness: 1e6}\n"), "");
}

TEST(Symbols, AreSpelledOut) {
  EXPECT_THAT(refusalOf("    model: M6\n"), HasSubstr("did you mean 'berg'?"));
  EXPECT_THAT(refusalOf("    model: maxwell\n    specification: {K_st: 3e6}\n"),
              HasSubstr("did you mean 'static_stiffness'?"));
  EXPECT_THAT(refusalOf("    model: multi_maxwell\n    specification: {maxwell_elements: 1}\n"),
              HasSubstr("model: maxwell for a single element"));
}

}  // namespace
}  // namespace rubber_suspension
