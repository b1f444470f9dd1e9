// Component files: accepted files, and that written files read back to the same numbers.
#include "rubber_suspension/io/component_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <type_traits>

#include "element/largest_number.h"
#include "rubber_suspension/element/constants.h"
#include "support/scratch_folder.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

const char* const kExample = R"(components:
  left_secondary:
    model: multi_maxwell
    specification:
      static_stiffness: 3.0e6
      dynamic_stiffness: "4.2 kN/mm"
      nominal_frequency: 4.0
      maximum_stiffness: 4.9 MN/m
      high_frequency: 25
    add:
      - {type: friction, maximum_force: 6 kN, displacement: 2.2 mm}
  bush:
    model: elements
    elements:
      - type: spring
        stiffness: 1e6
)";

std::vector<io::ComponentDescription> parse(const std::string& text) {
  return io::parseComponentFile(text, "file.yaml");
}

std::string errorOf(const std::string& text) {
  return messageOf<io::ComponentFileError>([&] { parse(text); });
}

TEST(ComponentFile, LoadsModelsAndElementsWithUnits) {
  const auto components = parse(kExample);
  ASSERT_EQ(components.size(), 2u);
  EXPECT_EQ(components[0].name, "left_secondary");
  EXPECT_EQ(components[0].model(), estimation::Model::multi_maxwell);
  EXPECT_EQ(components[0].specification().at("static_stiffness"), 3.0e6);
  EXPECT_DOUBLE_EQ(components[0].specification().at("dynamic_stiffness"), 4.2e6);
  EXPECT_DOUBLE_EQ(components[0].specification().at("maximum_stiffness"), 4.9e6);
  ASSERT_EQ(components[0].add.size(), 1u);
  EXPECT_EQ(components[0].add[0].type, "friction");
  EXPECT_EQ(components[0].add[0].value("maximum_force"), 6000.0);
  EXPECT_EQ(components[0].add[0].value("displacement"), 0.0022);
  EXPECT_EQ(components[1].model(), estimation::Model::elements);
  EXPECT_EQ(components[1].allElements().at(0).value("stiffness"), 1e6);
  // The elements are a spring, five Maxwell elements and the friction under `add`.
  EXPECT_EQ(components[0].allElements().size(), 7u);
}

TEST(ComponentFile, AnglesAndPercentAreConverted) {
  const auto components = parse(R"(components:
  a:
    model: kelvin_voigt
    specification: {dynamic_stiffness: 4.2e6, nominal_frequency: 4, loss_angle: 5.7 deg}
  b:
    model: kelvin_voigt
    specification: {dynamic_stiffness: 4.2e6, nominal_frequency: 4, relative_damping: 5 %}
)");
  EXPECT_DOUBLE_EQ(components[0].specification().at("loss_angle"), 5.7 * element::kPi / 180.0);
  EXPECT_DOUBLE_EQ(components[1].specification().at("relative_damping"), 0.05);
}

// The parameter server passes "3.0e6" as text, because YAML 1.1 requires a sign in the exponent.
std::string withTolerance(const std::string& tolerance) {
  return "components:\n  a:\n    model: kelvin_voigt\n    specification:\n      dynamic_stiffness: 4e6\n"
         "      nominal_frequency: 4\n      loss_angle: 0.1\n      tolerance: " +
         tolerance + "\n";
}

TEST(ComponentFile, ToleranceOfTheSheetReadsBack) {
  const double guess = estimation::SheetTolerance::kGuess;
  const std::vector<std::tuple<std::string, double, double>> cases = {
      {"10 %", 0.1, 0.1},
      {"0.03", 0.03, 0.03},
      {"guess", guess, guess},
      {"{dynamic_stiffness: 5 %, loss_angle: guess}", 0.05, guess},
      {"{loss_angle: 0.2}", estimation::SheetTolerance::kUsual, 0.2}};
  for (const auto& [text, of_stiffness, of_angle] : cases) {
    const auto components = parse(withTolerance(text));
    for (const auto& read : {components, parse(io::toYaml(components))}) {
      const estimation::SheetTolerance& tolerance = read[0].specification().tolerance();
      EXPECT_DOUBLE_EQ(tolerance.of("dynamic_stiffness"), of_stiffness) << text;
      EXPECT_DOUBLE_EQ(tolerance.of("loss_angle"), of_angle) << text;
      EXPECT_TRUE(tolerance.given());
    }
  }
  EXPECT_EQ(io::toYaml(parse(kExample)).find("tolerance"), std::string::npos) << "nobody gave one";
}

TEST(ComponentFile, TolerancesOfElementsReadBack) {
  const double guess = estimation::SheetTolerance::kGuess;
  const auto components = parse(
      "components:\n  a:\n    model: elements\n    tolerance: guess\n    elements:\n"
      "      - {type: spring, stiffness: 1 kN/mm, tolerance: 5 %}\n      - {type: dashpot, damping: 2e3}\n");
  for (const auto& read : {components, parse(io::toYaml(components))}) {
    EXPECT_DOUBLE_EQ(read[0].tolerance.of("spring[0]"), 0.05);
    EXPECT_DOUBLE_EQ(read[0].tolerance.of("dashpot[1]"), guess);
  }
  const std::string listed =
      "components:\n  a:\n    model: elements\n    elements:\n      - {type: spring, stiffness: 1";
  EXPECT_THAT(
      errorOf(listed + ", tolerance: geuss}\n"),
      HasSubstr("elements[0].tolerance: 'geuss' is not a tolerance (did you mean 'guess'?); accepted: a share"));
  EXPECT_THAT(errorOf(listed + "}\n    add:\n      - {type: spring, stiffness: 1, tolerance: 5 %}\n"),
              HasSubstr("add[0].tolerance: unknown key"));
  EXPECT_THAT(errorOf(withTolerance("5 %") + "    tolerance: 5 %\n"), HasSubstr("tolerance: unknown key"));
}

TEST(ComponentFile, RefusesATolerance) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"geuss", "'geuss' is not a tolerance (did you mean 'guess'?); accepted: a share such as 10 %"},
      {"0", "'0' is out of range; accepted: a number in (0, 1], or in %"},
      {"-5 %", "out of range"},
      {"150 %", "out of range"},
      {"3 mm", "'3 mm'"},
      {"", "nothing is not a tolerance"},
      {"[0.1]", "a list is not a tolerance"},
      {"{}", "an empty map; accepted: a map of dynamic_stiffness, loss_angle"},
      {"{nominal_frequency: 5 %}", "tolerance.nominal_frequency: unknown key; accepted: dynamic_stiffness, loss_angle"},
      {"{static_stiffness: 5 %}", "tolerance.static_stiffness: unknown key"},
      {"{loss_angle: {}}", "tolerance.loss_angle: an empty map is not a tolerance"}};
  for (const auto& [text, message] : cases) {
    const std::string error = errorOf(withTolerance(text));
    EXPECT_THAT(error, HasSubstr("file.yaml:8: component 'a': specification.tolerance")) << text;
    EXPECT_THAT(error, HasSubstr(message)) << text;
  }
}

TEST(ComponentFile, ANumberAsTextIsInSiUnits) {
  const auto components = parse("components: {a: {model: elements, elements: [{type: spring, stiffness: '3.0e6'}]}}");
  EXPECT_EQ(components[0].elements()[0].value("stiffness"), 3.0e6);
}

TEST(ComponentFile, AnAliasIsAPlainCopy) {
  const auto components = parse(R"(components:
  a:
    model: elements
    elements: &bush
      - {type: spring, stiffness: 1.0e+6}
  b:
    model: elements
    elements: *bush
)");
  EXPECT_EQ(components[1].elements()[0].value("stiffness"), 1e6);
}

TEST(ComponentFile, AliasesThatMultiplyAreRefusedAtOnce) {
  std::string text = "a0: &a0 [x, x]\n";
  for (int i = 1; i < 60; ++i) {  // would expand to 2^60 values
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [*a" + std::to_string(i - 1) + ", *a" +
            std::to_string(i - 1) + "]\n";
  }
  EXPECT_THAT(errorOf(text), HasSubstr("each alias"));
  EXPECT_THAT(errorOf("components: &c\n  a: *c\n"), HasSubstr("file.yaml:"));
}

TEST(ComponentFile, DeepNestingIsRefused) {
  EXPECT_THAT(errorOf("components: " + std::string(500000, '[')),
              HasSubstr("file.yaml:1: the file is nested too deeply; accepted"));
  std::string nested;
  for (int depth = 0; depth < 1200; ++depth) {
    nested += std::string(static_cast<std::size_t>(depth), ' ') + "a:\n";
  }
  EXPECT_THAT(errorOf(nested), HasSubstr("file.yaml:202: the file is nested too deeply; accepted"));
  std::string dashes;
  for (int i = 0; i < 200000; ++i) {
    dashes += "- ";
  }
  EXPECT_THAT(errorOf(dashes), HasSubstr("file.yaml:1: the file is nested too deeply; accepted"));
}

TEST(ComponentFile, SizesAreBounded) {
  EXPECT_THAT(errorOf(std::string(io::kMaximumComponentFileSize + 1, '#')),
              HasSubstr("bytes; accepted: at most 1048576"));

  std::string many = "components:\n";
  for (std::size_t i = 0; i <= io::kMaximumComponents; ++i) {
    many += "  c" + std::to_string(i) + ": {}\n";
  }
  EXPECT_THAT(errorOf(many), HasSubstr("257 components; accepted: at most 256"));

  std::string entries = "components: {a: {model: elements, elements: [";
  for (std::size_t i = 0; i <= io::kMaximumElements; ++i) {
    entries += "{},";
  }
  EXPECT_THAT(errorOf(entries + "]}}"), HasSubstr("elements: the list has 1001 elements; accepted: at most 1000"));
}

TEST(ComponentFile, ErrorsAreOneLine) {
  const std::string error = errorOf("components: {a: {model: \"bad\\nmodel\\n" + std::string(1000, 'x') + "\"}}");
  EXPECT_EQ(error.find('\n'), std::string::npos);
  EXPECT_LT(error.size(), 400u);
}

TEST(ComponentFile, NamesAFileThatCannotBeRead) {
  EXPECT_THROW(io::loadComponentFile("/nonexistent/file.yaml"), io::ComponentFileError);
  EXPECT_THROW(io::loadComponentFile("/"), io::ComponentFileError);
  EXPECT_THROW(io::loadComponentFile("/dev/zero"), io::ComponentFileError);
  const TemporaryFile pipe("pipe.yaml", "");
  ASSERT_EQ(unlink(pipe.path().c_str()), 0);
  ASSERT_EQ(mkfifo(pipe.path().c_str(), 0600), 0);
  EXPECT_THROW(io::loadComponentFile(pipe.path()), io::ComponentFileError);  // does not wait for a writer
}

// The specification is read-only, so that the estimated elements always match it. It can only be replaced as a whole.
TEST(ComponentDescription, HasTheElementsOfItsSpecification) {
  using Access = decltype(std::declval<io::ComponentDescription&>().specification());
  static_assert(std::is_same_v<Access, const estimation::Specification&>);
  io::ComponentDescription component = parse(kExample).at(0);
  const auto estimated = [&] { return estimation::estimate(component.model(), component.specification()); };
  const auto stiffnessOf = [](const std::vector<element::ElementDescription>& elements) {
    return elements.at(0).value("stiffness");
  };
  EXPECT_EQ(stiffnessOf(component.elements()), stiffnessOf(estimated()));
  estimation::Specification other = component.specification();
  other.set("static_stiffness", 3.1e6);
  component.specify(other);
  EXPECT_EQ(stiffnessOf(component.elements()), 3.1e6);
  EXPECT_EQ(stiffnessOf(component.elements()), stiffnessOf(estimated()));
  EXPECT_EQ(component.allElements().size(), component.elements().size() + component.add.size());
  other.set("static_stiffness", 5e6);  // larger than the dynamic stiffness
  EXPECT_THROW(component.specify(other), std::invalid_argument);
  EXPECT_EQ(component.specification().at("static_stiffness"), 3.1e6);
  EXPECT_EQ(stiffnessOf(component.elements()), 3.1e6);
}

TEST(ComponentDescription, OfElementsHasNoSpecification) {
  io::ComponentDescription component("bush", {{"spring", {{"stiffness", {1e6}}}}});
  EXPECT_EQ(component.model(), estimation::Model::elements);
  EXPECT_THROW(component.specify({}), std::logic_error);
  EXPECT_EQ(component.allElements().size(), 1u);
}

TEST(SelectComponent, TakesTheNamedOrTheOnlyOne) {
  const auto two = parse(kExample);
  EXPECT_EQ(io::selectComponent(two, "bush").name, "bush");
  EXPECT_THROW(io::selectComponent(two, "brush"), io::ComponentFileError);
  const std::string message =
      messageOf<io::ComponentFileError>([&] { io::selectComponent(two, "left_secondry", "file.yaml"); });
  EXPECT_EQ(message,
            "file.yaml: there is no component 'left_secondry' (did you mean 'left_secondary'?); accepted: "
            "left_secondary, bush");
  EXPECT_THROW(io::selectComponent(two, ""), io::ComponentFileError);
  const auto one = parse("components: {a: {model: elements, elements: [{type: spring, stiffness: 1}]}}");
  EXPECT_EQ(io::selectComponent(one, "").name, "a");
}

// Values cover the range of accepted exponents, for the parameters of every law that accepts them.
TEST(ToYaml, ReadsBackBitByBit) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(-100.0, 30.0);
  std::vector<element::ElementDescription> elements;
  std::vector<element::ElementDescription> add;
  for (int i = 0; i < 200; ++i) {
    elements.push_back({"spring", {{"stiffness", {std::pow(10.0, exponent(random))}}}});
    add.push_back({"maxwell",
                   {{"stiffness", {std::pow(10.0, exponent(random))}},
                    {"break_frequency", {std::pow(10.0, exponent(random) / 10.0)}}}});
  }
  elements.push_back({"spring", {{"stiffness", {element::kSmallestNumber}}}});
  io::ComponentDescription component("random", std::move(elements));
  component.add = std::move(add);
  const auto read = parse(io::toYaml({component}));
  ASSERT_EQ(read.size(), 1u);
  ASSERT_EQ(read[0].elements().size(), component.elements().size());
  for (std::size_t i = 0; i < component.elements().size(); ++i) {
    EXPECT_EQ(read[0].elements()[i].values, component.elements()[i].values);
  }
  ASSERT_EQ(read[0].add.size(), component.add.size());
  for (std::size_t i = 0; i < component.add.size(); ++i) {
    EXPECT_EQ(read[0].add[i].values, component.add[i].values);
  }
}

TEST(ToYaml, ReadsBackASpecification) {
  const auto components = parse(kExample);
  const auto read = parse(io::toYaml(components));
  ASSERT_EQ(read.size(), components.size());
  EXPECT_EQ(read[0].specification().values(), components[0].specification().values());
  EXPECT_EQ(read[0].add[0].values, components[0].add[0].values);
  EXPECT_EQ(io::toYaml(read), io::toYaml(components));
}

const char* const kWithTemperature = R"(components:
  bush:
    model: elements
    elements:
      - {type: spring, stiffness: 1e6}
    temperature: {shift: wlf, c1: 6.14, c2: 146.6 K, reference: 293.15 K, vertical: proportional}
)";

TEST(ComponentFile, ValidDisplacement) {
  const auto loaded = [](const std::string& value) {
    return io::parseComponentFile(
               "components: {a: {model: elements, elements: [{type: spring, stiffness: 1e6}], "
               "valid_displacement: " +
                   value + "}}",
               "")
        .front();
  };
  const auto one = loaded("12 mm").validDisplacement();
  ASSERT_TRUE(one);
  EXPECT_DOUBLE_EQ(one->lower, -0.012);
  EXPECT_DOUBLE_EQ(one->upper, 0.012);
  const io::ComponentDescription two = loaded("[-0.01, 8 mm]");
  EXPECT_DOUBLE_EQ(two.validDisplacement()->lower, -0.01);
  EXPECT_DOUBLE_EQ(two.validDisplacement()->upper, 0.008);
  const auto again = io::parseComponentFile(io::toYaml({two}), "").front().validDisplacement();
  EXPECT_EQ(again->lower, two.validDisplacement()->lower);
  EXPECT_EQ(again->upper, two.validDisplacement()->upper);
  for (const char* bad : {"0", "-1 mm", "[8 mm, -1 mm]", "[1 mm]", "[1, 2, 3]", "12 N", "{}"}) {
    EXPECT_THROW(loaded(bad), io::ComponentFileError) << bad;
  }
}

TEST(ComponentFile, ExcludedEffectsAreReadAsTheyAreWritten) {
  io::ComponentDescription component("bush", {{"spring", {{"stiffness", {1e6}}}}});
  component.excluded_effects = {"free_play", "backlash"};
  EXPECT_EQ(io::parseComponentFile(io::toYaml({component}), "").front().excluded_effects, component.excluded_effects);
}

TEST(ComponentFile, HoldsAFluidAsItIsWritten) {
  io::ComponentDescription component("mount", {{"spring", {{"stiffness", {1e6}}}}});
  EXPECT_FALSE(io::parseComponentFile(io::toYaml({component}), "").front().holds_fluid);
  component.holds_fluid = true;
  EXPECT_TRUE(io::parseComponentFile(io::toYaml({component}), "").front().holds_fluid);
}

TEST(ComponentDescription, IsValidWhereItSaysNothingWithinItsTables) {
  const io::ComponentDescription spring("a", {{"spring", {{"stiffness", {1e6}}}}});
  EXPECT_FALSE(spring.validDisplacement());
  io::ComponentDescription table = spring;
  table.add = {{"spring_table", {{"displacement", {-4e-3, 0.0, 3e-3}}, {"force", {-2e4, 0.0, 1e4}}}}};
  ASSERT_TRUE(table.validDisplacement());
  EXPECT_EQ(table.validDisplacement()->lower, -4e-3);
  EXPECT_EQ(table.validDisplacement()->upper, 3e-3);
  const std::string friction =
      "components: {a: {model: friction, specification: {static_stiffness: 3e6, dynamic_stiffness: 4.2e6, "
      "nominal_frequency: 4, nominal_amplitude: 2 mm, loss_angle: 4 deg}}}";
  EXPECT_FALSE(io::parseComponentFile(friction, "").front().validDisplacement());  // a nominal amplitude is not a bound
}

// Absolute temperatures are converted with the offset of their scale, differences without it. The factor b_T = T/T_0 on
// the force corresponds to the coefficient 1/T_0.
TEST(ComponentFile, TemperatureWithUnits) {
  const io::ComponentDescription bush = parse(kWithTemperature).at(0);
  ASSERT_TRUE(bush.temperature);
  EXPECT_EQ(bush.temperature->type, "wlf_shift");
  EXPECT_DOUBLE_EQ(bush.temperature->value("c2"), 146.6);
  EXPECT_NEAR(bush.temperature->value("reference"), 20.0, 1e-12);
  EXPECT_NEAR(bush.temperature->value("vertical"), 1.0 / 293.15, 1e-17);
  EXPECT_EQ(bush.allElements().back().type, "wlf_shift");
  EXPECT_TRUE(bush.makeComponent().shiftsWithTemperature());
}

TEST(ComponentFile, TemperatureInOtherWords) {
  const auto with = [](const std::string& temperature) {
    return *parse("components: {bush: {model: elements, elements: [{type: spring, stiffness: 1e6}], temperature: {" +
                  temperature + "}}}")
                .at(0)
                .temperature;
  };
  const element::ElementDescription arrhenius =
      with("shift: arrhenius, activation_energy: 50 kJ/mol, reference: 68 degF, vertical: -0.002");
  EXPECT_DOUBLE_EQ(arrhenius.value("activation_energy"), 5e4);
  EXPECT_NEAR(arrhenius.value("reference"), 20.0, 1e-12);
  EXPECT_DOUBLE_EQ(arrhenius.value("vertical"), -0.002);
  EXPECT_DOUBLE_EQ(with("shift: wlf, c1: 6.14, c2: 146.6 kelvin, reference: 20").value("reference"), 20.0);
  EXPECT_DOUBLE_EQ(with("shift: wlf, c1: 6, c2: 50, reference: 20, vertical: none").value("vertical"), 0.0);
}

TEST(ComponentFile, TemperatureReadsBackToTheSameNumbers) {
  const std::vector<io::ComponentDescription> written = parse(kWithTemperature);
  const io::ComponentDescription read = parse(io::toYaml(written)).at(0);
  ASSERT_TRUE(read.temperature);
  EXPECT_EQ(read.temperature->type, written[0].temperature->type);
  EXPECT_EQ(read.temperature->values, written[0].temperature->values);
}

}  // namespace
}  // namespace rubber_suspension
