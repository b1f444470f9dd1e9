// Bushing property files: read again, block by block, as other programs read them.
#include "command/bushing_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::command {
namespace {

using testing::Contains;
using testing::HasSubstr;

// Lines by block, without comments.
std::map<std::string, std::vector<std::string>> blocksOf(const std::string& text) {
  std::map<std::string, std::vector<std::string>> blocks;
  std::string block;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line[0] == '$') {
      continue;
    }
    if (line[0] == '[') {
      block = line.substr(1, line.find(']') - 1);
      blocks[block];
    } else {
      blocks[block].push_back(line);
    }
  }
  return blocks;
}

std::vector<std::pair<double, double>> curveOf(const std::vector<std::string>& lines) {
  std::vector<std::pair<double, double>> curve;
  for (const std::string& line : lines) {
    std::istringstream stream(line);
    double x = 0.0;
    double force = 0.0;
    stream >> x >> force;
    EXPECT_FALSE(stream.fail()) << line;
    curve.emplace_back(x, force);
  }
  return curve;
}

BushingFileOptions options() { return {'x', 5e-3, 11, 4.0, 1e-3}; }

TEST(BushingFile, HasStaticCurveAndDampingInItsUnits) {
  const component::Component component({{"spring", {{"stiffness", {3e6}}}},
                                        {"progressive_stiffness", {{"cubic", {2e10}}}},
                                        {"dashpot", {{"damping", {8e3}}}}});
  const auto blocks = blocksOf(makeBushingFile("bush", component, options()).text);
  for (const char* block :
       {"MDI_HEADER", "UNITS", "DAMPING", "FX_CURVE", "FY_CURVE", "FZ_CURVE", "TX_CURVE", "TY_CURVE", "TZ_CURVE"}) {
    EXPECT_EQ(blocks.count(block), 1U) << block;
  }
  EXPECT_THAT(blocks.at("UNITS"), Contains(HasSubstr("LENGTH  =  'mm'")));
  const auto curve = curveOf(blocks.at("FX_CURVE"));
  ASSERT_EQ(curve.size(), 11U);
  for (const auto& [x, force] : curve) {
    const double z = 1e-3 * x;
    EXPECT_NEAR(force, 3e6 * z + 2e10 * z * z * z, 1e-6 * 3e6 * 5e-3);  // nine digits are written
  }
  EXPECT_EQ(curve.front().first, -5.0);
  EXPECT_EQ(curve[5], std::make_pair(0.0, 0.0));
  for (const auto& [x, force] : curveOf(blocks.at("FZ_CURVE"))) {
    EXPECT_EQ(force, 0.0);
  }
  // 8000 N s/m are 8 N s/mm. The loop of a cubic spring loses nothing.
  std::istringstream damping(blocks.at("DAMPING").front());
  std::string key;
  std::string equals;
  double value = 0.0;
  damping >> key >> equals >> value;
  EXPECT_EQ(key, "FX_DAMPING");
  EXPECT_NEAR(value, 8.0, 1e-6);  // the area of the loop, in closed form
}

TEST(BushingFile, TellsWhatTheFormatCannotSay) {
  const component::Component component(
      {{"spring", {{"stiffness", {3e6}}}}, {"maxwell", {{"stiffness", {1e6}}, {"break_frequency", {2.0}}}}});
  const BushingFile file = makeBushingFile("bush", component, options());
  EXPECT_THAT(file.notes, Contains(HasSubstr("maxwell: of it the file has the force at rest")));
  EXPECT_THAT(file.notes, Contains(HasSubstr("the other five directions")));
  // K* = 3 + i x/(1 + i x) kN/mm with x = f/f_b = 2: 3.8 + 0.4 i; of the file the real part is static.
  EXPECT_THAT(file.notes.front(), HasSubstr("at 4 Hz and 1 mm the component has 3.821 kN/mm and 6.01 degrees"));
  EXPECT_THAT(file.notes.front(), HasSubstr("the file 3.027 kN/mm and 7.59 degrees"));
}

TEST(BushingFile, RefusesOptionsThatMakeNoFile) {
  const component::Component component({{"spring", {{"stiffness", {3e6}}}}});
  const auto refuses = [&](const BushingFileOptions& wrong) {
    EXPECT_THROW(makeBushingFile("bush", component, wrong), std::invalid_argument);
  };
  refuses({'w', 5e-3, 11, 4.0, 1e-3});
  refuses({'x', 0.0, 11, 4.0, 1e-3});
  refuses({'x', 5e-3, 10, 4.0, 1e-3});
  refuses({'x', 5e-3, 11, 0.0, 1e-3});
  refuses({'x', 5e-3, 11, 4.0, -1.0});
}

}  // namespace
}  // namespace rubber_suspension::command
