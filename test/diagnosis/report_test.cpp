// The sentences of a report, its record of the run, and the numbers behind its figures.
#include <sys/wait.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "diagnosis/effect.h"
#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/report/report_figures.h"
#include "diagnosis/report/report_parts.h"
#include "diagnosis/report/run_record.h"
#include "diagnosis/words/candidates.h"
#include "diagnosis/words/model_values.h"
#include "diagnosis/words/sentence.h"
#include "diagnosis/words/text.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/iwan.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

using diagnosis::headlineValuesOf;
using diagnosis::words::quantity;

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
  std::string content(200000, 'x');  // read in several blocks
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

double named(const std::vector<diagnosis::HeadlineValue>& values, const std::string& name) {
  const auto found = std::find_if(values.begin(), values.end(), [&](const auto& value) { return value.name == name; });
  return found == values.end() ? std::numeric_limits<double>::quiet_NaN() : found->value;
}

// Sliders with a friction of 6 kN, half of this force at 0.35 mm, are reported with these two numbers.
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
  // A single slider has half of its force at half of its yield displacement.
  const auto one = headlineValuesOf({{"iwan_table", {{"yield_displacement", {2e-3}}, {"stiffness", {1e6}}}}});
  EXPECT_NEAR(named(one, "displacement"), 1e-3, 1e-15);
}

// All three elements are parts of the same friction, so the report adds up their maximum forces.
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

// Several terms of one effect are summarised by one number. Parameters that no fit varies are omitted.
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

// Contacts in series are summarised by the preload of the first that opens and the total slack stiffness.
TEST(Headline, OfContactsAreTheirPreloadAndWhatHoldsThem) {
  const element::ElementDescription strap{"lift_off", {{"side", {1.0}}}};
  element::ElementDescription bolted = strap;
  bolted.values = {{"side", {1.0}}, {"preload", {800.0}}, {"slack_stiffness", {2e6}}};
  element::ElementDescription later = bolted;
  later.values["preload"] = {900.0};
  const auto both = headlineValuesOf({later, bolted});
  ASSERT_EQ(both.size(), 2U);
  EXPECT_DOUBLE_EQ(named(both, "slack_stiffness_in_compression"), 1e6);
  EXPECT_DOUBLE_EQ(named(both, "preload"), 800.0);
  const auto alone = headlineValuesOf({strap});
  ASSERT_EQ(alone.size(), 1U);
  EXPECT_EQ(named(alone, "slack_stiffness_in_compression"), 0.0);
}

TEST(ReportText, NamesTheSideInFrontOfItsValue) {
  using diagnosis::words::sizeName;
  EXPECT_EQ(sizeName({"bump_stop", "gap_in_tension", "m", 0.0, 2.4e-3, {}}), "gap in tension:");
  EXPECT_EQ(sizeName({"friction", "displacement", "m", 0.0, 1e-4, {}}), "half of this force at");
  EXPECT_EQ(sizeName({"friction", "maximum_force", "N", 0.0, 200.0, {}}), "maximum force");
}

TEST(ReportText, TellsTheEndsOfAnIntervalApart) {
  EXPECT_EQ(diagnosis::words::intervalText({"", "", "N/m", 0.0, 1.55e6, {1.5496e6, 1.5502e6}}),
            "1.5496 to 1.5502 kN/mm");
  EXPECT_EQ(diagnosis::words::intervalText({"", "", "N", 0.0, 5.0, {5.0, 5.0}}), "5 to 5 N");
  EXPECT_EQ(diagnosis::words::intervalText({"", "", "N", 0.0, 5.0, {4.0, 5.0}, {false, true}}),
            "4 N or more (the fit ended at a bound)");
  EXPECT_EQ(diagnosis::words::intervalText({"", "", "N", 0.0, 4.0, {4.0, 5.0}, {true, false}}),
            "5 N or less (the fit ended at a bound)");
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
  EXPECT_EQ(diagnosis::words::whyOut(d, creep),
            "the gap is 11.0 % with the full law of this effect, and 2.0 % with the named effects");
  creep.interval = {-0.1, 0.1};
  EXPECT_THAT(diagnosis::words::whyOut(d, creep), HasSubstr("may remove nothing"));
  creep.testable = false;
  creep.visible_share = 0.03;
  EXPECT_THAT(diagnosis::words::whyOut(d, creep), HasSubstr("all but 3 %"));
  creep.effect = "friction";
  EXPECT_EQ(diagnosis::words::whyOut(d, creep), "");
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

// These phrases appear on the first screen of a page, where test/report/render_test.py looks for them.
TEST(InWords, HasWhatTheFirstScreenShows) {
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
  const auto report = nlohmann::json::parse(toJson(d));
  const auto& words = report.at("in_words");
  EXPECT_EQ(words.at("headline"), "The model lacks friction: gap 12.0 % to 2.0 %.");
  EXPECT_EQ(words.at("verdict"), "the model lacks the effects named here");
  EXPECT_EQ(words.at("probability"), "97 %");
  EXPECT_EQ(words.at("gap").dump(),
            R"({"as_configured":"14.0 %","augmented":"2.0 %","noise_floor":"1.5 %","re_estimated":"12.0 %"})");
  EXPECT_EQ(words.at("closed").dump(), R"(["94","92","100"])");
  EXPECT_EQ(words.at("shares").dump(), R"([{"by":"values","share":"14 %"},{"by":"friction","share":"72 %"}])");
  const std::vector<std::array<std::string, 3>> law = {{"maximum force", "6 kN", "5.7 to 6.4 kN"},
                                                       {"half of this force at", "0.35 mm", "0.3 to 0.4 mm"},
                                                       {"gap in compression:", "2.4 mm", "2.2 to 2.6 mm"},
                                                       {"change of stiffness", "falls by 0.6 %/K", "-0.7 to -0.5 %/K"}};
  ASSERT_EQ(words.at("law").size(), law.size());
  for (std::size_t i = 0; i < law.size(); ++i) {
    EXPECT_EQ(words.at("law").at(i).at("number"), law[i][0]);
    EXPECT_EQ(words.at("law").at(i).at("value"), law[i][1]);
    EXPECT_EQ(words.at("law").at(i).at("interval_95"), law[i][2]);
  }
  EXPECT_EQ(report.at("where_after").size(), 1U);
  EXPECT_NEAR(report.at("where").at(0).at("squared_gap").get<double>(), 0.0121, 1e-12);
  EXPECT_THAT(report.at("experiment").at("how_to_play").get<std::string>(), HasSubstr("(2 s at 100 Hz"));
  EXPECT_THAT(report.at("experiment").at("command").get<std::string>(), HasSubstr("component:=bush <1>"));
}

TEST(Sentence, SaysWhatAFurtherLogWillShow) {
  diagnosis::Diagnosis d;
  d.gaps.unseen = {0.14, 0.12, 0.02, 0.015};
  EXPECT_THAT(diagnosis::words::headline(d), Not(HasSubstr("further")));
  d.gaps.further_log = 0.031;
  for (const auto verdict : {diagnosis::Verdict::none, diagnosis::Verdict::parameter_error, diagnosis::Verdict::named,
                             diagnosis::Verdict::confounded, diagnosis::Verdict::unknown}) {
    d.answer.verdict = verdict;
    if (diagnosis::namesEffects(verdict)) {
      d.answer.effects = {"friction"};
      d.law.added_for = {"friction"};
    }
    EXPECT_THAT(diagnosis::words::headline(d), HasSubstr(", 3.1 % on further logs"));
    EXPECT_THAT(diagnosis::words::sentence(d), HasSubstr(", 3.1 % on further logs"));
    d.answer.effects.clear();
  }
}

TEST(Sentence, SaysWhatIsWithheld) {
  diagnosis::Diagnosis d;
  d.answer.verdict = diagnosis::Verdict::named;
  d.answer.effects = {"friction"};
  d.shares = {{"values", 0.2}, {"friction", 0.0}};
  d.law.withheld = {{"friction", "sweep", 0.024, 0.031}};
  const std::string said = diagnosis::words::sentence(d);
  EXPECT_THAT(said,
              HasSubstr("Friction is not written: with it, the gap of the component file would be 3.10 % on log sweep, "
                        "but it is 2.40 % as configured."));
  EXPECT_THAT(said, Not(HasSubstr("Adding it removes")));
  EXPECT_THAT(said, Not(HasSubstr("friction removes")));
  d.law.withheld.push_back({"values", "", 0.024, 0.026});
  EXPECT_THAT(diagnosis::words::sentence(d),
              HasSubstr(": the component file removes nothing of the gap as configured."));
}

TEST(Sentence, SaysWhichLogReadsOtherwise) {
  diagnosis::Diagnosis d;
  d.logs.admission.resize(3);
  const auto gain = [](const std::string& log, double value) {
    measurement::RigFinding finding;
    finding.log = log;
    finding.finding = measurement::finding::kSensorGain;
    finding.value = value;
    finding.beyond_tolerance = true;
    return finding;
  };
  d.rig_findings = {gain("b", 0.098)};
  EXPECT_THAT(diagnosis::words::sentence(d), HasSubstr("Log b has forces 10 % higher than the other logs."));
  d.rig_findings = {gain("b", -0.052)};
  EXPECT_THAT(diagnosis::words::sentence(d), HasSubstr("Log b has forces 5 % lower than the other logs."));
  d.rig_findings = {gain("a", 0.15), gain("b", 0.045), gain("c", 0.155)};
  EXPECT_THAT(
      diagnosis::words::sentence(d),
      HasSubstr("Logs a and c have forces 10 % higher than b; the logs do not determine which of them are right."));
}

TEST(Sentence, SaysThatAllDisplacementsHaveOneSign) {
  diagnosis::Diagnosis d;
  auto workings = std::make_shared<diagnosis::Workings>();
  d.workings = workings;
  workings->simulated.records.resize(2);
  workings->simulated.records[0].displacement = Eigen::ArrayXd::LinSpaced(9, -2e-3, 1e-5);
  workings->simulated.records[1].displacement = Eigen::ArrayXd::LinSpaced(9, -1e-3, -5e-4);
  EXPECT_THAT(diagnosis::words::sentence(d), HasSubstr(" All displacements are negative: these logs do not determine "
                                                       "the force at positive displacements."));
  workings->simulated.records[1].displacement *= -1.0;
  EXPECT_THAT(diagnosis::words::sentence(d), Not(HasSubstr("All displacements")));
}

// No effect is named first if none has a probability of at least one half.
TEST(Sentence, ListsWhatMayBeWhereNoEffectIsLikely) {
  diagnosis::Diagnosis d;
  d.answer.verdict = diagnosis::Verdict::confounded;
  d.answer.effects = {"creep"};
  d.answer.posterior = {0.01, 0.02, 0.76, 0.21};
  d.law.added_for = {"creep"};
  d.candidates.resize(3);
  d.candidates[0].effect = "friction";
  d.candidates[0].probability = 0.43;
  d.candidates[1].effect = "creep";
  d.candidates[1].probability = 0.19;
  d.candidates[2].effect = "inertia";
  d.candidates[2].probability = 0.03;
  const std::string list = "friction (43 %), something that is not in the list (21 %)";
  EXPECT_THAT(diagnosis::words::sentence(d),
              StartsWith("The missing effect is uncertain with these logs; possible: " + list + " and creep (19 %)."));
  EXPECT_THAT(diagnosis::words::headline(d), HasSubstr(list + ", creep (19 %)"));
  EXPECT_THAT(diagnosis::words::headline(d), Not(HasSubstr("lacks creep")));
  d.candidates[1].probability = 0.51;
  EXPECT_THAT(diagnosis::words::headline(d), HasSubstr("lacks creep"));
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
