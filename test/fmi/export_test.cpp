// The exporter: its description follows the rules of the standard. Also its archive and its refusals.
#include "fmi/export.h"

#include "element/typical_elements.h"
#include "fmi/description_check.h"
#include "fmi/runtime/embedded.h"
#include "fmi/zip_reader.h"
#include "support/test.h"

namespace rubber_suspension::fmi::test {
namespace {

FmuParts parts() { return {FMU_BINARY, FMU_SOURCES}; }

std::string makeFmu(const io::ComponentDescription& description, Version version, const FmuParts& from) {
  return toZip(fmuFiles(description, version, from));
}

// Returns all models of the example, and a component with all laws.
std::vector<io::ComponentDescription> components() {
  auto list = io::loadComponentFile(TEST_DIR "/../config/example.yaml");
  list.emplace_back("all_laws", rubber_suspension::test::typicalElements());
  return list;
}

std::string contentOf(const std::string& fmu, const std::string& path) {
  for (const ArchiveEntry& entry : fromZip(fmu, "FMU")) {
    if (entry.path == path) {
      return entry.content;
    }
  }
  return "";
}

TEST(Description, KeepsTheRulesOfTheStandard) {
  for (const io::ComponentDescription& component : components()) {
    for (const Version version : {Version::fmi2, Version::fmi3}) {
      const std::string xml = modelDescription(dataOf(component), version, "test 1.0");
      EXPECT_THAT(brokenRules(xml, version), IsEmpty()) << component.name;
    }
  }
}

TEST(Description, RulesThatAreBrokenAreFound) {
  struct Damage {
    const char* what;
    const char* with;
    const char* rule;
  };
  const std::vector<Damage> damages = {
      {"fmiVersion=\"2.0\"", "fmiVersion=\"1.0\"", "fmiVersion"},
      {" guid=", " id=", "lacks guid"},
      {"modelIdentifier=\"bush\"", "modelIdentifier=\"2bush\"", "a name in C"},
      {"canGetAndSetFMUstate=\"true\"", "canGetAndSetFMUstate=\"yes\"", "no boolean"},
      {"canGetAndSetFMUstate=\"true\"", "canGetAndSetFMUstate=\"false\"", "can be saved"},
      {"<Unit name=\"N\">", "<Unit name=\"kN\">", "its unit is defined"},
      {"name=\"force\"", "name=\"displacement\"", "the name stands once"},
      {"name=\"force\"", "name=\"the force\"", "a structured name"},
      {"valueReference=\"3\"", "valueReference=\"2\"", "reference stands once"},
      {"causality=\"input\" variability=\"continuous\"", "causality=\"input\" variability=\"fixed\"", "go together"},
      {"variability=\"fixed\" initial=\"exact\"", "variability=\"fixed\" initial=\"calculated\"", "initial"},
      {"<Real unit=\"m\" start=\"0\"/>", "<Real unit=\"m\"/>", "start where"},
      {"<Real unit=\"N\"/>", "<Real unit=\"N\" start=\"0\"/>", "start where"},
      {"start=\"3000000\"", "start=\"-1\"", "min <= start"},
      {"<Unknown index=\"3\" dependencies=\"\"/>", "", "exactly the outputs"},
      {"<Unknown index=\"3\"/>", "", "initial unknowns"},
      {"ModelVariables", "ModelVariable", "stands where"},
      {"causality=\"output\"", "causality=\"local\"", "exactly the outputs"},
  };
  const std::string xml = modelDescription(
      dataOf(io::ComponentDescription("bush", {{"spring", {{"stiffness", {3e6}}}}})), Version::fmi2, "t");
  ASSERT_THAT(brokenRules(xml, Version::fmi2), IsEmpty());
  for (const Damage& damage : damages) {
    std::string damaged = xml;
    ASSERT_NE(damaged.find(damage.what), std::string::npos) << damage.what;
    for (std::size_t at = 0; (at = damaged.find(damage.what, at)) != std::string::npos;) {
      damaged.replace(at, std::string(damage.what).size(), damage.with);
      at += std::string(damage.with).size();
    }
    EXPECT_THAT(brokenRules(damaged, Version::fmi2), Contains(HasSubstr(damage.rule))) << damage.with;
  }
  EXPECT_FALSE(brokenRules(xml, Version::fmi3).empty());
  EXPECT_FALSE(brokenRules("no XML", Version::fmi2).empty());
}

TEST(Description, EveryUnitOfTheTablesIsKnown) {
  for (const element::ElementType& type : element::elementTypes()) {
    for (const element::ParameterInfo& parameter : type.parameters) {
      EXPECT_NO_THROW(baseUnitOf(parameter.unit)) << type.name << "." << parameter.name;
    }
  }
  for (const element::ParameterInfo& parameter : estimation::specificationParameters()) {
    EXPECT_NO_THROW(baseUnitOf(parameter.unit)) << parameter.name;
  }
}

TEST(Units, AreTakenApart) {
  using Base = BaseUnit;
  EXPECT_EQ(baseUnitOf("1"), Base());
  EXPECT_EQ(baseUnitOf("N s/m"), (Base{{"kg", 1}, {"s", -1}}));
  EXPECT_EQ(baseUnitOf("N/m^5"), (Base{{"kg", 1}, {"m", -4}, {"s", -2}}));
  EXPECT_EQ(baseUnitOf("1/J"), (Base{{"kg", -1}, {"m", -2}, {"s", 2}}));
  EXPECT_EQ(baseUnitOf("J/mol"), (Base{{"kg", 1}, {"m", 2}, {"s", -2}, {"mol", -1}}));
  EXPECT_EQ(baseUnitOf("degC"), (Base{{"K", 1}}));
  EXPECT_EQ(offsetOf("degC"), 273.15);
  EXPECT_EQ(offsetOf("K"), 0.0);
  EXPECT_THROW(baseUnitOf("furlong"), std::invalid_argument);
  EXPECT_THROW(baseUnitOf("m^"), std::invalid_argument);
  EXPECT_THROW(baseUnitOf(""), std::invalid_argument);
}

TEST(Data, SurvivesTheWayThroughText) {
  for (const io::ComponentDescription& component : components()) {
    const ComponentData data = dataOf(component);
    const ComponentData read = fromJson(toJson(data));
    EXPECT_EQ(toJson(read), toJson(data));
    const auto expected = component.makeComponent().elements();
    const auto elements = read.allElements();
    ASSERT_EQ(elements.size(), expected.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
      EXPECT_EQ(elements[i].type, expected[i].type);
      EXPECT_EQ(elements[i].values, expected[i].values);
    }
  }
  EXPECT_ANY_THROW(fromJson(""));
  EXPECT_ANY_THROW(fromJson("{}"));
}

TEST(Archive, HoldsWhatTheStandardWants) {
  const io::ComponentDescription bush("bush", {{"spring", {{"stiffness", {3e6}}}}});
  const std::string second = makeFmu(bush, Version::fmi2, parts());
  const std::string third = makeFmu(bush, Version::fmi3, parts());
  EXPECT_EQ(second.substr(0, 4), "PK\x03\x04");
  EXPECT_FALSE(contentOf(second, "binaries/linux64/bush.so").empty());
  EXPECT_FALSE(contentOf(third, "binaries/x86_64-linux/bush.so").empty());
  for (const Version version : {Version::fmi2, Version::fmi3}) {
    const std::vector<ArchiveEntry> packed = fromZip(version == Version::fmi2 ? second : third, "FMU");
    const std::vector<ArchiveEntry> files = fmuFiles(bush, version, parts());
    ASSERT_EQ(packed.size(), files.size());
    for (std::size_t i = 0; i < files.size(); ++i) {
      EXPECT_EQ(packed[i].path, files[i].path);
      EXPECT_TRUE(packed[i].content == files[i].content) << files[i].path;
    }
  }
  EXPECT_THAT(brokenRules(contentOf(second, "modelDescription.xml"), Version::fmi2), IsEmpty());
  EXPECT_THAT(brokenRules(contentOf(third, "modelDescription.xml"), Version::fmi3), IsEmpty());
  const auto read = io::parseComponentFile(contentOf(second, "resources/component.yaml"), "component.yaml");
  EXPECT_EQ(read.at(0).elements().at(0).value("stiffness"), 3e6);
  EXPECT_THAT(contentOf(second, "sources/CMakeLists.txt"), HasSubstr("set(model_identifier bush)"));
  EXPECT_THAT(contentOf(second, "sources/component_text.h"), HasSubstr("\"name\":\"bush\""));
  EXPECT_THAT(contentOf(second, "sources/src/component/component.cpp"), HasSubstr("Component::step"));
  EXPECT_FALSE(contentOf(second, "sources/LICENSE").empty());
}

TEST(Archive, IsTheSameForTheSameComponent) {
  const io::ComponentDescription bush("bush", {{"spring", {{"stiffness", {3e6}}}}});
  const io::ComponentDescription softer("bush", {{"spring", {{"stiffness", {2e6}}}}});
  EXPECT_EQ(makeFmu(bush, Version::fmi2, parts()), makeFmu(bush, Version::fmi2, parts()));
  EXPECT_NE(dataOf(bush).guid, dataOf(softer).guid);
}

TEST(Archive, WithoutItsPartsIsRefused) {
  const io::ComponentDescription bush("bush", {{"spring", {{"stiffness", {3e6}}}}});
  const auto make = [&](const FmuParts& wrong) { return [&, wrong] { makeFmu(bush, Version::fmi2, wrong); }; };
  EXPECT_THAT(make({"/nowhere.so", FMU_SOURCES}), ThrowsMessage<std::runtime_error>(HasSubstr("/nowhere.so")));
  EXPECT_THAT(make({FMU_BINARY, "/nowhere"}), ThrowsMessage<std::runtime_error>(HasSubstr("/nowhere")));
  EXPECT_THAT(make({TEST_DIR "/../LICENSE", FMU_SOURCES}), ThrowsMessage<std::runtime_error>(HasSubstr("no block")));
  EXPECT_THAT(make({FMU_BINARY, FMU_BINARY}), ThrowsMessage<std::runtime_error>(HasSubstr(".so")));
}

TEST(Archive, TakesNoComponentThatIsTooLarge) {
  std::vector<double> displacement;
  std::vector<double> force;
  for (int i = 0; i < 40000; ++i) {
    displacement.push_back(1e-7 * (i - 20000) / 3.0);
    force.push_back(0.3 * (i - 20000) / 7.0);
  }
  const io::ComponentDescription large("large", {{"spring_table", {{"displacement", displacement}, {"force", force}}}});
  EXPECT_THAT([&] { makeFmu(large, Version::fmi2, parts()); }, ThrowsMessage<std::runtime_error>(HasSubstr("at most")));
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__clang__)  // a binary with sanitizers needs their libraries
std::string outputOf(const std::string& command) {
  std::string output;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::array<char, 4096> part{};
  for (std::size_t count = 0; pipe && (count = std::fread(part.data(), 1, part.size(), pipe.get())) > 0;) {
    output.append(part.data(), count);
  }
  return output;
}

// The binary links the C library and its mathematics only, and exports the functions of the standard only.
TEST(Binary, StandsAlone) {
  const std::string dynamic = outputOf("readelf -d -W " FMU_BINARY);
  ASSERT_THAT(dynamic, HasSubstr("NEEDED"));
  for (const char* library : {"libstdc++", "libgcc_s", "libfmt", "librubber", "SONAME", "RPATH", "RUNPATH"}) {
    EXPECT_THAT(dynamic, testing::Not(HasSubstr(library)));
  }
  const std::string symbols = outputOf("nm -D --defined-only --format=posix " FMU_BINARY);
  std::istringstream lines(symbols);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    const std::string start = line.substr(0, 4);
    EXPECT_TRUE(start == "fmi2" || start == "fmi3") << line;
  }
  EXPECT_GT(count, 100U);
}
#endif

}  // namespace
}  // namespace rubber_suspension::fmi::test
