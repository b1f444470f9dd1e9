// Bushing property files are parsed block by block, as other programs do.
#include "command/bushing_file.h"

#include "rubber_suspension/element/constants.h"
#include "support/test.h"

namespace rubber_suspension::command {
namespace {

// Returns the lines of each block, without comments.
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

BushingFileOptions options(BushingFormat format = BushingFormat::adams) {
  return {format, 11, 4.0, {5e-3, 1e-3}, {0.1, 0.02}};
}

Bushing alongX(const component::Component& component) { return bushingAlong(component::kX, component); }

// Returns the value in a line `KEY = value`.
std::string valueOf(const std::vector<std::string>& lines, const std::string& key) {
  for (const std::string& line : lines) {
    std::istringstream stream(line);
    std::string name;
    std::string equals;
    std::string value;
    stream >> name >> equals >> value;
    if (name == key && equals == "=") {
      return value;
    }
  }
  return "";
}

double numberOf(const std::vector<std::string>& lines, const std::string& key) {
  return std::strtod(valueOf(lines, key).c_str(), nullptr);
}

TEST(BushingFile, HasStaticCurveAndDampingInItsUnits) {
  const component::Component component({{"spring", {{"stiffness", {3e6}}}},
                                        {"progressive_stiffness", {{"cubic", {2e10}}}},
                                        {"dashpot", {{"damping", {8e3}}}}});
  const auto blocks = blocksOf(makeBushingFile("bush", alongX(component), options()).text);
  for (const char* block :
       {"MDI_HEADER", "UNITS", "DAMPING", "FX_CURVE", "FY_CURVE", "FZ_CURVE", "TX_CURVE", "TY_CURVE", "TZ_CURVE"}) {
    EXPECT_EQ(blocks.count(block), 1U) << block;
  }
  EXPECT_THAT(blocks.at("UNITS"), Contains(HasSubstr("LENGTH  =  'mm'")));
  const auto curve = curveOf(blocks.at("FX_CURVE"));
  ASSERT_EQ(curve.size(), 11U);
  for (const auto& [x, force] : curve) {
    const double z = 1e-3 * x;
    EXPECT_NEAR(force, 3e6 * z + 2e10 * z * z * z, 1e-6 * 3e6 * 5e-3);  // the file has nine digits
  }
  EXPECT_EQ(curve.front().first, -5.0);
  EXPECT_EQ(curve[5], std::make_pair(0.0, 0.0));
  for (const auto& [x, force] : curveOf(blocks.at("FZ_CURVE"))) {
    EXPECT_EQ(force, 0.0);
  }
  // 8000 N s/m are 8 N s/mm, computed from the area of the loop. The cubic spring dissipates no energy.
  EXPECT_NEAR(numberOf(blocks.at("DAMPING"), "FX_DAMPING"), 8.0, 1e-6);
  EXPECT_EQ(numberOf(blocks.at("DAMPING"), "FY_DAMPING"), 0.0);
}

TEST(BushingFile, TellsWhatTheFormatCannotSay) {
  const component::Component component(
      {{"spring", {{"stiffness", {3e6}}}}, {"maxwell", {{"stiffness", {1e6}}, {"break_frequency", {2.0}}}}});
  const BushingFile file = makeBushingFile("bush", alongX(component), options());
  EXPECT_THAT(file.notes, Contains(HasSubstr("maxwell: of this element the file contains only the force at rest")));
  EXPECT_THAT(file.notes, Contains(HasSubstr("y, z, rx, ry, rz: free")));
  // K* = 3 + i x/(1 + i x) kN/mm is 3.8 + 0.4 i for x = f/f_b = 2. Its real part in the file is the static stiffness.
  EXPECT_THAT(file.notes.front(), HasSubstr("x: at 4 Hz and 1 mm the component has 3.821 kN/mm and 6.01 degrees"));
  EXPECT_THAT(file.notes.front(), HasSubstr("the file 3.027 kN/mm and 7.59 degrees"));
}

TEST(BushingFile, RefusesOptionsThatMakeNoFile) {
  const component::Component component({{"spring", {{"stiffness", {3e6}}}}});
  const auto refuses = [&](int points, double frequency, const BushingCurve& translation) {
    const BushingFileOptions wrong{BushingFormat::adams, points, frequency, translation, {}};
    EXPECT_THROW(makeBushingFile("bush", alongX(component), wrong), std::invalid_argument);
  };
  refuses(11, 4.0, {0.0, 1e-3});
  refuses(10, 4.0, {5e-3, 1e-3});
  refuses(11, 0.0, {5e-3, 1e-3});
  refuses(11, 4.0, {5e-3, -1.0});
}

// Returns a table of F = 3e6 z + 2e10 z^3 at eleven points.
element::ElementDescription springTable() {
  std::vector<double> displacement;
  std::vector<double> force;
  for (int i = -5; i <= 5; ++i) {
    displacement.push_back(1e-3 * i);
    force.push_back(3e6 * displacement.back() + 2e10 * std::pow(displacement.back(), 3));
  }
  return {"spring_table", {{"displacement", displacement}, {"force", force}}};
}

// x and y share a law with a table, z is linear, rx has a spring and a dashpot, and ry and rz are free.
component::SixDirections sixDirections() {
  component::SixDirectionsLaws laws;
  laws.elements[component::kX] = {springTable()};
  laws.elements[component::kZ] = {{"spring", {{"stiffness", {1e6}}}}};
  laws.elements[component::kRx] = {{"spring", {{"stiffness", {900.0}}}}, {"dashpot", {{"damping", {5.0}}}}};
  laws.translation = component::Coupling::cylindrical;
  laws.on_a.translation().x() = 0.1;
  return component::SixDirections(laws);
}

constexpr double kDegree = element::kPi / 180.0;

TEST(BushingFile, HasSixDirectionsForAdams) {
  const BushingFile file = makeBushingFile("bush", bushingOf(sixDirections()), options());
  const auto blocks = blocksOf(file.text);
  EXPECT_EQ(blocks.at("FX_CURVE"), blocks.at("FY_CURVE"));
  EXPECT_NEAR(curveOf(blocks.at("FX_CURVE")).back().second, 3e6 * 5e-3 + 2e10 * std::pow(5e-3, 3), 1e-4);
  EXPECT_NEAR(curveOf(blocks.at("FZ_CURVE")).back().second, 5e3, 1e-5);
  const auto moments = curveOf(blocks.at("TX_CURVE"));
  EXPECT_NEAR(moments.back().first, 0.1 / kDegree, 1e-7);
  EXPECT_NEAR(moments.back().second, 900.0 * 0.1 * 1e3, 1e-4);                           // [N mm]
  EXPECT_NEAR(numberOf(blocks.at("DAMPING"), "TX_DAMPING"), 5.0 * 1e3 * kDegree, 1e-5);  // [N mm s/deg]
  EXPECT_EQ(curveOf(blocks.at("TY_CURVE")).back().second, 0.0);
  EXPECT_THAT(file.notes, Contains(HasSubstr("coupling: the file cannot represent the coupling")));
  EXPECT_THAT(file.notes, Contains(HasSubstr("ry, rz: free")));
  EXPECT_THAT(file.notes, Contains(HasSubstr("frame: ")));
}

// Returns the rows of the activity table by formulation.
std::map<std::string, std::string> activity(const std::vector<std::string>& lines) {
  std::map<std::string, std::string> rows;
  for (const std::string& line : lines) {
    std::istringstream stream(line);
    std::string formulation;
    stream >> formulation;
    std::string columns;
    for (std::string entry; stream >> entry;) {
      columns += entry;
    }
    rows[formulation] = columns;
  }
  return rows;
}

TEST(BushingFile, HasSixDirectionsForAltair) {
  const BushingFile file = makeBushingFile("bush", bushingOf(sixDirections()), options(BushingFormat::altair));
  const auto blocks = blocksOf(file.text);
  EXPECT_EQ(valueOf(blocks.at("HEADER"), "FILE_TYPE"), "'gbs'");
  EXPECT_EQ(valueOf(blocks.at("UNITS"), "ANGLE"), "'degree'");
  EXPECT_EQ(valueOf(blocks.at("GLOBAL"), "COUPLING"), "'cylindrical'");
  const auto table = activity(blocks.at("DIRECTIONS"));
  EXPECT_EQ(table.count("(ACTIVITY)"), 1U);
  EXPECT_EQ(table.at("{"), "formulationFXFYFZTXTYTZ}");
  EXPECT_EQ(table.at("'SPLINE_STIFFNESS'"), "110000");
  EXPECT_EQ(table.at("'CONSTANT_STIFFNESS'"), "001100");
  EXPECT_EQ(table.at("'CONSTANT_DAMPING'"), "111100");
  for (const char* none : {"'CUBIC_STIFFNESS'", "'RUBBER_DAMPING'", "'HYDROMOUNT_DAMPING'"}) {
    EXPECT_EQ(table.at(none), "000000");
  }
  const std::vector<std::string>& spline = blocks.at("SPLINE_STIFFNESS_FX");
  EXPECT_EQ(spline[0], "(SPLINE_DATA)");
  EXPECT_EQ(spline[1], "{ disp  force }");
  const auto curve = curveOf({spline.begin() + 2, spline.end()});
  ASSERT_EQ(curve.size(), 11U);
  EXPECT_NEAR(curve.back().second, 3e6 * 5e-3 + 2e10 * std::pow(5e-3, 3), 1e-4);
  EXPECT_NEAR(numberOf(blocks.at("CONSTANT_STIFFNESS_FZ"), "K"), 1e3, 1e-6);                    // [N/mm]
  EXPECT_NEAR(numberOf(blocks.at("CONSTANT_STIFFNESS_TX"), "K"), 900.0 * 1e3 * kDegree, 1e-4);  // [N mm/deg]
  EXPECT_NEAR(numberOf(blocks.at("CONSTANT_DAMPING_TX"), "C"), 5.0 * 1e3 * kDegree, 1e-5);
  EXPECT_EQ(blocks.count("CONSTANT_DAMPING_TY"), 0U);
  EXPECT_THAT(
      file.notes,
      Contains(HasSubstr("coupling: the file has a single coupling for forces and moments")));  // not for moments here
}

}  // namespace
}  // namespace rubber_suspension::command
