// The report's page, its record of the run, and the numbers behind its figures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/report/page.h"
#include "diagnosis/report/report_figures.h"
#include "diagnosis/report/run_record.h"
#include "diagnosis/results/headline.h"
#include "diagnosis/words/model_values.h"
#include "diagnosis/words/sentence.h"
#include "diagnosis/words/text.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/iwan.h"

namespace rubber_suspension {
namespace {

using diagnosis::results::headlineValuesOf;
using diagnosis::words::quantity;
using testing::HasSubstr;
using testing::Not;

// Colours of the style sheet's variables, by block: light, dark, print.
std::vector<std::map<std::string, std::array<double, 3>>> palettes(const std::string& style) {
  std::vector<std::map<std::string, std::array<double, 3>>> result;
  const std::regex block(R"(:root\s*\{([^}]*)\})");
  const std::regex variable(R"(--(\w+):\s*#([0-9a-f]{6}))");
  for (std::sregex_iterator b(style.begin(), style.end(), block); b != std::sregex_iterator(); ++b) {
    const std::string body = (*b)[1];
    std::map<std::string, std::array<double, 3>> palette;
    for (std::sregex_iterator v(body.begin(), body.end(), variable); v != std::sregex_iterator(); ++v) {
      const unsigned long rgb = std::stoul((*v)[2], nullptr, 16);
      palette[(*v)[1]] = {static_cast<double>(rgb >> 16U) / 255.0, static_cast<double>((rgb >> 8U) & 255U) / 255.0,
                          static_cast<double>(rgb & 255U) / 255.0};
    }
    result.push_back(palette);
  }
  return result;
}

// WCAG 2.1, relative luminance and contrast ratio.
double luminance(const std::array<double, 3>& rgb) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(rgb[0]) + 0.7152 * linear(rgb[1]) + 0.0722 * linear(rgb[2]);
}

double contrast(const std::array<double, 3>& one, const std::array<double, 3>& other) {
  const double a = luminance(one);
  const double b = luminance(other);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

TEST(ReportPage, HasTheContrastOfLevelAA) {
  const auto schemes = palettes(diagnosis::report::kPageStyle);
  ASSERT_EQ(schemes.size(), 3U) << "light, dark, print";
  for (const auto& scheme : schemes) {
    for (const char* text : {"ink", "note", "link", "added", "removed"}) {
      for (const char* background : {"paper", "soft"}) {
        EXPECT_GE(contrast(scheme.at(text), scheme.at(background)), 4.5) << text << " on " << background;
      }
    }
    EXPECT_GE(contrast(scheme.at("mark"), scheme.at("paper")), 3.0) << "bars and the line beside the verdict";
  }
}

// No measure of the style sheet is wider than a page of 400 px; what depends on the screen's width is.
TEST(ReportPage, AsksForNoWidthBeyond400Pixels) {
  const std::string style = diagnosis::report::kPageStyle;
  const std::regex width(R"((^|[^-])\b(min-width|width|minmax\(min\(100%,):?\s*([\d.]+)(rem|px)\b)");
  int found = 0;
  for (std::sregex_iterator m(style.begin(), style.end(), width); m != std::sregex_iterator(); ++m) {
    if ((*m)[2] == "width" || (*m)[2] == "min-width") {
      EXPECT_LE(std::stod((*m)[3]) * ((*m)[4] == "rem" ? 16.0 : 1.0), 400.0 - 32.0) << (*m)[0];
      ++found;
    }
  }
  EXPECT_GT(found, 0);
  EXPECT_THAT(style, HasSubstr("overflow-wrap: anywhere"));
  EXPECT_THAT(style, HasSubstr("minmax(min(100%,"));
}

TEST(ReportTable, TellsTheTitleOfEachField) {
  EXPECT_THAT(diagnosis::words::table({"log", "#gap"}, {{"sine", "7.9 %"}}),
              HasSubstr("<td data-title=\"log\">sine</td><td class=n data-title=\"gap\">7.9 %</td>"));
  EXPECT_THROW(diagnosis::words::table({"log", "#gap"}, {{"sine"}}), std::logic_error);
}

TEST(ReportText, HasUnitsThatEngineersRead) {
  EXPECT_EQ(quantity(6000.0, "N"), "6 kN");
  EXPECT_EQ(quantity(-31.0, "N"), "-31 N");
  EXPECT_EQ(quantity(3.5e-4, "m"), "0.35 mm");
  EXPECT_EQ(quantity(4.2e6, "N/m"), "4.2 kN/mm");
  EXPECT_EQ(quantity(2.1e-4, "s"), "0.21 ms");
  EXPECT_EQ(quantity(0.0, "m"), "0 µm");
  EXPECT_EQ(quantity(1.5, "1"), "1.5");
  EXPECT_EQ(quantity({"friction", "maximum_force", "N", 0.0, 6000.0, {950.0, 6400.0}}), "6 kN (0.95 to 6.4 kN)");
}

TEST(ReportText, NeverLeavesHtmlOfAName) {
  EXPECT_EQ(diagnosis::words::escape("<b a=\"1\">&"), "&lt;b a=&quot;1&quot;&gt;&amp;");
}

std::string outputOf(const std::string& command) {
  std::FILE* const pipe = popen(command.c_str(), "r");
  std::array<char, 4096> buffer{};
  std::string text;
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) {
    text += buffer.data();
  }
  EXPECT_EQ(pclose(pipe), 0) << command;
  return text;
}

TEST(RunRecord, NamesFilesByTheirSha256) {
  const std::string path = testing::TempDir() + "run record's file";
  std::string content(200000, 'x');  // more than one portion
  content += '\0';
  std::ofstream(path, std::ios::binary) << content;
  setenv("SOURCE_DATE_EPOCH", "86399", 1);
  const auto record = diagnosis::report::makeRunRecord("1.2", {"diagnose", "--log", path}, {{"--log", path}});
  unsetenv("SOURCE_DATE_EPOCH");
  ASSERT_EQ(record.files.size(), 1U);
  EXPECT_EQ(record.files[0].name, "run record's file");
  EXPECT_EQ(record.files[0].sha256, outputOf("sha256sum < \"" + path + "\" | cut -d' ' -f1 | tr -d '\\n'"));
  EXPECT_EQ(record.date, "1970-01-01T23:59:59Z");
  EXPECT_EQ(outputOf("printf %s " + record.command_line.substr(std::string("diagnose --log ").size())), path)
      << "the shell reads the quoted path back";
  std::remove(path.c_str());
  EXPECT_THROW(diagnosis::report::makeRunRecord("1", {}, {{"--log", path}}), std::runtime_error) << "the file is gone";
}

TEST(RunRecord, RefusesADateThatIsNone) {
  for (const char* bad : {"yesterday", "-1", "1e9", "99999999999999999999", "12 "}) {
    setenv("SOURCE_DATE_EPOCH", bad, 1);
    EXPECT_THROW(diagnosis::report::makeRunRecord("1", {}, {}), std::runtime_error) << bad;
  }
  unsetenv("SOURCE_DATE_EPOCH");
}

TEST(FigureData, HoldsEveryPointAndNoHoles) {
  io::Axes axes;
  axes.title = "a \"b\"";
  axes.x_label = "displacement [mm]";
  axes.y_label = "force [kN]";
  axes.curves.push_back({"measured", {1.0, 2.0, 3.0}, {0.5, std::numeric_limits<double>::quiet_NaN(), 1.5}});
  EXPECT_EQ(diagnosis::report::figureCsv({"t", {axes}, 1}),
            "curve,panel,displacement_mm,force_kN\n\"measured\",\"a \"\"b\"\"\",1,0.5\n"
            "\"measured\",\"a \"\"b\"\"\",3,1.5\n");
}

TEST(FigureData, HoldsTheCellsOfAMap) {
  io::Axes axes;
  axes.x_label = "frequency [Hz]";
  axes.y_label = "amplitude [mm]";
  axes.maps.push_back({{1.0, 2.0, 4.0}, {0.1, 1.0}, {std::numeric_limits<double>::quiet_NaN(), 7.0}, "share [%]"});
  EXPECT_EQ(diagnosis::report::figureCsv({"t", {axes}, 1}),
            "curve,panel,frequency_Hz_low,frequency_Hz_high,amplitude_mm_low,amplitude_mm_high,value\n"
            "\"share [%]\",\"\",2,4,0.1,1,7\n");
}

double named(const std::vector<diagnosis::results::HeadlineValue>& values, const std::string& name) {
  const auto found = std::find_if(values.begin(), values.end(), [&](const auto& value) { return value.name == name; });
  return found == values.end() ? std::numeric_limits<double>::quiet_NaN() : found->value;
}

// Sliders that realise a friction of 6 kN, half of it at 0.35 mm, are told as just that.
TEST(Headline, TellsSlidersAsForceAndDisplacementAtHalfForce) {
  element::ElementDescription table{"iwan_table", {{"yield_displacement", {}}, {"stiffness", {}}}};
  for (const element::JenkinsSlider& slider : element::iwanSliders(6000.0, 3.5e-4, 64)) {
    table.values["yield_displacement"].push_back(slider.yield_displacement);
    table.values["stiffness"].push_back(slider.stiffness);
  }
  std::reverse(table.values["yield_displacement"].begin(), table.values["yield_displacement"].end());
  std::reverse(table.values["stiffness"].begin(), table.values["stiffness"].end());
  const auto values = headlineValuesOf({table});
  EXPECT_NEAR(named(values, "maximum_force"), 6000.0, 1e-6);
  EXPECT_NEAR(named(values, "displacement"), 3.5e-4, 0.02 * 3.5e-4) << "chords of the hyperbola cut its corner";
  // One slider: half of its force at half of its way.
  const auto one = headlineValuesOf({{"iwan_table", {{"yield_displacement", {2e-3}}, {"stiffness", {1e6}}}}});
  EXPECT_NEAR(named(one, "displacement"), 1e-3, 1e-15);
}

// What a rate brings to its limit, or what grows, is part of the same friction: the limits add up.
TEST(Headline, AddsUpTheLimitsOfAllThatYields) {
  const std::vector<element::ElementDescription> friction = {
      {"iwan_table", {{"yield_displacement", {2e-3}}, {"stiffness", {1e6}}}},
      {"variable_friction", {{"stiffness", {5e5}}, {"yield_displacement", {2e-3}}, {"growth_displacement", {0.01}}}},
      {"viscoplastic_friction", {{"stiffness", {5e5}}, {"yield_displacement", {2e-3}}, {"half_rate", {0.1}}}}};
  const auto values = headlineValuesOf(friction);
  ASSERT_EQ(values.size(), 2U);
  EXPECT_DOUBLE_EQ(named(values, "maximum_force"), 4000.0);
  EXPECT_DOUBLE_EQ(named(values, "displacement"), 1e-3);
  EXPECT_DOUBLE_EQ(named(headlineValuesOf(friction), "maximum_force"), 4000.0);
  const auto alone = headlineValuesOf({friction.back()});
  EXPECT_DOUBLE_EQ(named(alone, "maximum_force"), 1000.0);
}

// What people read is few numbers: seven terms of one effect are one, and what no fit moves is left out.
TEST(Headline, IsShortForPeople) {
  const auto softening =
      headlineValuesOf({{"stress_softening", {{"reduction", {0.2}}, {"width", {0.05}}, {"path", {1.0}}}},
                        {"stress_softening", {{"reduction", {0.3}}, {"width", {0.5}}, {"path", {2.0}}}}});
  ASSERT_EQ(softening.size(), 1U);
  EXPECT_EQ(softening[0].name, "total_reduction");
  EXPECT_DOUBLE_EQ(softening[0].value, 1.0 - 0.8 * 0.7) << "one after the other, so never 1 or more";
  const auto stop = headlineValuesOf({{"bump_stop", {{"stiffness", {1e6}}, {"gap", {0.002}}}}});
  EXPECT_DOUBLE_EQ(named(stop, "stiffness"), 1e6);
  EXPECT_DOUBLE_EQ(named(stop, "gap"), 0.002);
}

TEST(ReportText, NamesTheSideInFrontOfItsValue) {
  using diagnosis::words::sizeName;
  EXPECT_EQ(sizeName({"bump_stop", "gap_in_tension", "m", 0.0, 2.4e-3, {}}), "gap in tension:");
  EXPECT_EQ(sizeName({"friction", "displacement", "m", 0.0, 1e-4, {}}), "half of it at");
  EXPECT_EQ(sizeName({"friction", "maximum_force", "N", 0.0, 200.0, {}}), "maximum force");
}

TEST(ReportText, TellsTheEndsOfAnIntervalApart) {
  EXPECT_EQ(diagnosis::words::intervalText({"", "", "N/m", 0.0, 1.55e6, {1.5496e6, 1.5502e6}}),
            "1.5496 to 1.5502 kN/mm");
  EXPECT_EQ(diagnosis::words::intervalText({"", "", "N", 0.0, 5.0, {5.0, 5.0}}), "5 to 5 N");
  EXPECT_EQ(diagnosis::words::intervalText({"", "", "N", 0.0, 5.0, {4.0, 5.0}, {false, true}}),
            "4 N or more, the fit ends at a bound");
  EXPECT_EQ(diagnosis::words::intervalText({"", "", "N", 0.0, 4.0, {4.0, 5.0}, {true, false}}),
            "5 N or less, the fit ends at a bound");
}

diagnosis::Diagnosis withSizes(std::vector<diagnosis::SizedValue> sizes) {
  diagnosis::Diagnosis d;
  d.law.model_sizes = std::move(sizes);
  return d;
}

TEST(ModelValues, AreTheFactWhereTheLogsContradictThem) {
  const auto d = withSizes({{"specification", "static_stiffness", "N/m", 3.0e6, 3.05e6, {2.9e6, 3.2e6}},
                            {"specification", "dynamic_stiffness", "N/m", 3.4e6, 4.2e6, {4.1e6, 4.3e6}},
                            {"specification", "break_frequency", "Hz", 1.0, 1.1, {1.05, 1.2}}});
  const auto changed = diagnosis::words::changedValues(d);
  ASSERT_EQ(changed.size(), 2U) << "the first one's interval holds the configured value";
  EXPECT_EQ(diagnosis::words::offText(*changed[0]),
            "K_n is 19 % too low in the component file (3.4 kN/mm instead of 4.2 kN/mm)");
}

TEST(Candidates, AreOutForAReason) {
  diagnosis::Diagnosis d;
  d.answer.effects = {"friction"};
  d.gaps.unseen = {0.14, 0.12, 0.02, 0.015};
  diagnosis::CandidateResult creep;
  creep.effect = "creep";
  creep.gap = 0.11;
  creep.interval = {0.05, 0.1};
  creep.testable = true;
  EXPECT_EQ(diagnosis::report::whyOut(d, creep), "leaves 11.0 %, where what is named leaves 2.0 %");
  creep.interval = {-0.1, 0.1};
  EXPECT_THAT(diagnosis::report::whyOut(d, creep), HasSubstr("may remove nothing"));
  creep.testable = false;
  creep.visible_share = 0.03;
  EXPECT_THAT(diagnosis::report::whyOut(d, creep), HasSubstr("leave 3 %"));
  creep.effect = "friction";
  EXPECT_EQ(diagnosis::report::whyOut(d, creep), "");
}

TEST(Findings, AllHaveAMeaningAndARemedy) {
  std::ifstream header(std::string(TEST_DIR) + "/../include/rubber_suspension/measurement/rig_finding.h");
  const std::string text((std::istreambuf_iterator<char>(header)), {});
  const std::regex name(R"re(inline constexpr const char\* \w+ = "(\w+)")re");
  int count = 0;
  for (std::sregex_iterator m(text.begin(), text.end(), name); m != std::sregex_iterator(); ++m, ++count) {
    EXPECT_FALSE(diagnosis::report::adviceOn((*m)[1]).meaning.empty()) << (*m)[1];
    EXPECT_FALSE(diagnosis::report::adviceOn((*m)[1]).remedy.empty()) << (*m)[1];
  }
  EXPECT_GE(count, 15);
}

// Whoever sees the first screen alone can say where, which, how far, how sure, and what next.
TEST(FirstScreen, AnswersTheFiveQuestions) {
  diagnosis::Diagnosis d;
  d.component = "bush <1>";
  d.answer.verdict = diagnosis::Verdict::named;
  d.sentence = "The model lacks friction.";
  d.answer.effects = {"friction"};
  d.gaps.unseen = {0.14, 0.12, 0.02, 0.015};
  d.gaps.closed = 0.94;
  d.gaps.closed_interval = {0.92, 1.1};
  diagnosis::CandidateResult friction;
  friction.effect = "friction";
  friction.probability = 0.97;
  d.candidates = {friction};
  d.law.effect_sizes = {{"friction", "maximum_force", "N", 0.0, 6000.0, {5700.0, 6400.0}},
                        {"friction", "displacement", "m", 0.0, 3.5e-4, {3e-4, 4e-4}}};
  d.answer.probability = 0.97;
  d.shares = {{"values", 0.14}, {"friction", 0.72}};
  d.law.effect_sizes.push_back({"friction", "gap_in_compression", "m", 0.0, 2.4e-3, {2.2e-3, 2.6e-3}});
  d.law.effect_sizes.push_back({"friction", "change_of_stiffness", "1/K", 0.0, -6e-3, {-7e-3, -5e-3}});
  d.where.before = {{"sines", {2.0, 4.0}, {2e-4, 5e-4}, gap::Quantity::stiffness, 0.6, 10.0, 0.0121},
                    {"sines", {4.0, 8.0}, {2e-4, 5e-4}, gap::Quantity::loss, 0.4, 10.0, 0.0025}};
  d.where.after = {{"sines", {4.0, 8.0}, {2e-4, 5e-4}, gap::Quantity::loss, 1.0, 1.0, 0.0004}};
  d.next.text = "sine at 4 Hz";
  d.next.proposed.description = "sine";
  d.next.proposed.dt = 0.01;
  d.next.proposed.displacement.assign(201, 0.0);
  d.workings = std::make_shared<diagnosis::Workings>();
  const std::string html = diagnosis::report::firstScreen(d);
  for (const char* answer : {"bush &lt;1&gt;",
                             "<h1>The model lacks friction: gap 12.0 % to 2.0 %.</h1>",
                             "The model lacks friction.",
                             "maximum force</td>",
                             "6 kN</td>",
                             "5.7 to 6.4 kN</td>",
                             "gap in compression:</td>",
                             "2.4 mm</td>",
                             "falls by 0.6 %/K</td>",
                             "friction 72 %",
                             "other values 14 %",
                             "left 14 %",
                             "94 % is removed",
                             "whisker: 92 to 100 %",
                             "97 %",
                             "all else",
                             "class=\"s5 largest\">11</td>",
                             ">2.0</td>",
                             "at 2 to 4 Hz and 0.2 to 0.5 mm, most of it stiffness in sines",
                             "sine at 4 Hz",
                             "next_experiment.csv",
                             "(2 s at 100 Hz"}) {
    EXPECT_THAT(html, HasSubstr(answer));
  }
  EXPECT_THAT(html, Not(HasSubstr("nan")));
}

TEST(Headline, HasAtMost25Words) {
  diagnosis::Diagnosis d;
  d.gaps.unseen = {0.1412, 0.1234, 0.0212, 0.0151};
  d.configured = {"bush", {{"spring", {{"stiffness", {1e6}}}}}};
  d.law.model_sizes = {{"specification", "dynamic_stiffness", "N/m", 4e6, 3e6, {2.9e6, 3.1e6}}};
  for (const auto verdict : {diagnosis::Verdict::none, diagnosis::Verdict::parameter_error, diagnosis::Verdict::named,
                             diagnosis::Verdict::confounded, diagnosis::Verdict::unknown, diagnosis::Verdict::partly,
                             diagnosis::Verdict::check_bench, diagnosis::Verdict::defect}) {
    d.answer.verdict = verdict;
    if (diagnosis::namesEffects(verdict)) {
      d.answer.effects = {"rate_amplitude_coupling", "progressive_stiffness", "stress_softening", "viscous_damping"};
    }
    std::istringstream words(diagnosis::words::headline(d));
    const auto count = std::distance(std::istream_iterator<std::string>(words), {});
    EXPECT_GT(count, 2) << toString(verdict);
    EXPECT_LE(count, 25) << diagnosis::words::headline(d);
  }
}

}  // namespace
}  // namespace rubber_suspension
