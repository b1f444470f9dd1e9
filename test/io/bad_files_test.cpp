// Component files that must be refused. The first line of each, `# error: ...`, contains the beginning of the expected
// error, from the line number on.
#include "rubber_suspension/io/component_file.h"
#include "support/files.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

std::string nameOf(const ::testing::TestParamInfo<std::string>& info) {
  return std::filesystem::path(info.param).stem().string();
}

void expectError(const std::string& error, const std::string& path, const std::string& expected) {
  ASSERT_FALSE(expected.empty()) << path << " does not say which error it has to give";
  EXPECT_THAT(error, StartsWith(path + ":" + expected));
  EXPECT_THAT(error, HasSubstr("accepted"));
  EXPECT_THAT(error, Not(HasSubstr("\n")));
  EXPECT_LT(error.size(), path.size() + 1000);
}

class BadComponentFile : public ::testing::TestWithParam<std::string> {};

TEST_P(BadComponentFile, IsRefusedWithItsError) {
  const std::string mark = "# error: ";
  const std::string line = firstLine(GetParam());
  ASSERT_THAT(line, StartsWith(mark));
  expectError(messageOf<io::ComponentFileError>([&] { io::loadComponentFile(GetParam()); }), GetParam(),
              line.substr(mark.size()));
}

INSTANTIATE_TEST_SUITE_P(Files, BadComponentFile, ::testing::ValuesIn(filesIn("io/bad_component_files", ".yaml")),
                         nameOf);

TEST(BadFiles, AreAllThere) { EXPECT_GE(filesIn("io/bad_component_files", ".yaml").size(), 95u); }

}  // namespace
}  // namespace rubber_suspension
