// Validates the description against the schemas of the standard, if the schemas and xmllint are available.
#include <unistd.h>

#include "element/typical_elements.h"
#include "fmi/export.h"
#include "support/measured_data.h"
#include "support/test.h"

namespace rubber_suspension::fmi::test {
namespace {

struct Answer {
  int status = -1;
  std::string text;
};

Answer run(const std::string& command) {
  Answer answer;
  FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) {
    return answer;
  }
  std::array<char, 4096> buffer{};
  while (fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) {
    answer.text += buffer.data();
  }
  answer.status = pclose(pipe);
  return answer;
}

class Schema : public testing::TestWithParam<Version> {
 protected:
  static std::string path() {
    return measuredData(std::string("fmi_schema/") +
                        (GetParam() == Version::fmi2 ? "fmi2ModelDescription.xsd" : "fmi3ModelDescription.xsd"));
  }

  static Answer validate(const std::string& xml) {
    const auto file = std::filesystem::path(testing::TempDir()) / ("schema_" + std::to_string(getpid()) + ".xml");
    std::ofstream(file) << xml;
    Answer answer = run("xmllint --nonet --noout --schema '" + path() + "' '" + file.string() + "'");
    std::filesystem::remove(file);
    return answer;
  }
};

TEST_P(Schema, HoldsForEveryModelAndLaw) {
  if (!std::filesystem::exists(path())) {
    GTEST_SKIP() << path() << " is missing: schema/ of the repository of the FMI standard";
  }
  if (run("xmllint --version").status != 0) {
    GTEST_SKIP() << "xmllint is not installed (libxml2-utils)";
  }
  auto components = io::loadComponentFile(TEST_DIR "/../config/example.yaml");
  components.emplace_back("all_laws", rubber_suspension::test::typicalElements());
  std::string xml;
  for (const io::ComponentDescription& component : components) {
    xml = modelDescription(dataOf(component), GetParam(), "test 1.0");
    const Answer answer = validate(xml);
    EXPECT_EQ(answer.status, 0) << component.name << ": " << answer.text;
  }
  // The validation must detect this error.
  xml.replace(xml.find("modelName"), 9, "modelTitle");
  EXPECT_NE(validate(xml).status, 0);
}

INSTANTIATE_TEST_SUITE_P(BothVersions, Schema, testing::Values(Version::fmi2, Version::fmi3),
                         [](const auto& version) { return version.param == Version::fmi2 ? "fmi2" : "fmi3"; });

}  // namespace
}  // namespace rubber_suspension::fmi::test
