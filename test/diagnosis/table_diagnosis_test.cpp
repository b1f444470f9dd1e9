// The diagnosis of measured tables of stiffness and loss angle.
#include "rubber_suspension/diagnosis/table_diagnosis.h"

#include <nlohmann/json.hpp>

#include "diagnosis/checked_diagnosis.h"
#include "diagnosis/laboratory.h"
#include "diagnosis/table/measured_rows.h"
#include "rubber_suspension/element/constants.h"
#include "support/files.h"
#include "support/test.h"

namespace rubber_suspension::diagnosis {
namespace {

// Returns the table of a Zener solid with friction, measured once for several tests.
const fit::MeasuredTable& frictionTable() {
  static const fit::MeasuredTable table = Laboratory(1).table(with(kZener, kFriction));
  return table;
}

const Diagnosis& ofFrictionTable() {
  static const Diagnosis run = checkedTable(without(kZener), frictionTable());
  return run;
}

TEST(TableDiagnosis, NeverNamesWhatNoTableShows) {
  const Diagnosis& found = ofFrictionTable();
  ASSERT_TRUE(found.table.has_value());
  for (const char* effect : {"stress_softening", "self_heating", "creep", "force_offset", "force_drift"}) {
    EXPECT_THAT(found.table->never_shown, Contains(effect));
    const auto candidate = std::find_if(found.candidates.begin(), found.candidates.end(),
                                        [&](const CandidateResult& c) { return c.effect == effect; });
    ASSERT_NE(candidate, found.candidates.end());
    EXPECT_FALSE(candidate->testable) << effect;
    EXPECT_EQ(candidate->probability, 0.0) << effect;
  }
  EXPECT_THAT(found.table->never_shown,
              testing::ElementsAre("stress_softening", "self_heating", "creep", "force_offset", "force_drift"));
}

double gapOf(const io::ComponentDescription& description, const fit::MeasuredTable& table) {
  const component::Component component = description.makeComponent();
  std::vector<std::complex<double>> settled;
  for (const fit::TablePoint& row : table.points) {
    const auto loop = response::characteristicsAt(component, row.frequency, row.amplitude).characteristics;
    settled.push_back(std::polar(loop.stiffness, loop.loss_angle));
  }
  return fit::gapOfTable(table.points, settled);
}

// The report computes its gaps from the settled loops of `estimate --from-table`, not from loops of the search.
TEST(TableDiagnosis, TheAugmentedComponentLeavesWhatTheReportSays) {
  const fit::MeasuredTable table = Laboratory(3).table(with(kZener, kFriction));
  const Diagnosis found = checkedTable(without(kZener), table);
  const auto reloaded = componentOf(io::toYaml({found.law.augmented}));
  // Report and test sample a cycle differently, which changes the loop area of friction by some 1e-4.
  EXPECT_NEAR(gapOf(reloaded, table), found.gap_as_recorded.augmented, 1e-3);
  EXPECT_NEAR(gapOf(found.configured, table), found.gap_as_recorded.as_configured, 1e-3);
}

TEST(TableDiagnosis, SaysWhereByRows) {
  fit::MeasuredTable table = Laboratory(1, 1e-3).table(without(kZener));
  const std::size_t wrong = 8;
  table.points[wrong].stiffness *= 1.3;
  const Diagnosis found = checkedTable(without(kZener), table);
  ASSERT_THAT(found.where.before, Not(IsEmpty()));
  EXPECT_EQ(found.where.before.front().log, "lab");
  EXPECT_EQ(found.where.before.front().frequency[0], table.points[wrong].frequency);
  EXPECT_EQ(found.where.before.front().frequency[1], table.points[wrong].frequency);
  EXPECT_EQ(found.where.before.front().amplitude[0], table.points[wrong].amplitude);
  EXPECT_EQ(found.where.before.front().quantity, gap::Quantity::stiffness);
  EXPECT_GT(found.where.before.front().share, 0.9);
}

TEST(TableDiagnosis, ChecksTheBench) {
  fit::MeasuredTable table = Laboratory(1).table(without(kZener));
  for (fit::TablePoint& point : table.points) {
    point.stiffness *= 1000.0;
  }
  const Diagnosis found = checkedTable(without(kZener), table);
  EXPECT_EQ(found.answer.verdict, diagnosis::Verdict::check_bench);
  ASSERT_EQ(found.rig_findings.size(), 1U);
  EXPECT_EQ(found.rig_findings.front().finding, "unit_factor");
  EXPECT_THAT(found.sentence, HasSubstr("factor 1000"));
  EXPECT_THAT(toJson(found), HasSubstr("check_bench"));
}

TEST(TableDiagnosis, RefusesWhatItCannotUse) {
  const io::ComponentDescription component = without(kZener);
  fit::MeasuredTable few = Laboratory(1).table(component);
  few.points.resize(5);
  EXPECT_THAT([&] { diagnoseTable(component, few); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("lab: has only 5 rows; accepted: at least 6")));
  const fit::MeasuredTable table = Laboratory(1).table(component);
  EXPECT_THAT(
      [&] { diagnoseTable(with(kZener, "{type: self_heating, energy_sensitivity: 0.001, time_constant: 60}"), table); },
      ThrowsMessage<std::exception>(HasSubstr("self_heating")));
  const io::ComponentDescription shifting = bush(
      "{model: elements, elements: [{type: maxwell, stiffness: 1.0e6, break_frequency: 1.0}], temperature: "
      "{shift: arrhenius, reference: 20.0, activation_energy: 5.0e4}}");
  EXPECT_THAT([&] { diagnoseTable(shifting, table); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("bush: shifts with temperature, but lab has no column")));
}

// The rows span six decades of reduced frequency, but the model spans only three and lacks the temperature. The decades
// without a relaxation leave a residual of five times the noise.
TEST(TableDiagnosis, NamesTemperatureWhereOneCurveHoldsAllRows) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 3e-3);
  fit::MeasuredTable table;
  table.name = "sweeps";
  for (const double temperature : {5.0, 15.0, 25.0, 35.0}) {
    for (const double frequency : {0.1, 0.4, 1.6, 6.4, 25.0, 100.0}) {
      const double shift = 200e3 / 8.314462618 * (1.0 / (temperature + 273.15) - 1.0 / 293.15);
      const double order = 0.15;
      const auto pot = std::polar(std::pow(frequency * std::exp(shift), order), 0.5 * element::kPi * order);
      const auto k = (2e6 + 1e6 * pot) * std::complex<double>(1.0 + noise(random), noise(random));
      table.points.push_back({frequency, 1e-5, std::abs(k), std::arg(k), 0.0, temperature});
    }
  }
  const io::ComponentDescription model{
      "bush", {spring(2.4e6), maxwell(2.5e5, 0.1), maxwell(2.5e5, 1.0), maxwell(2.5e5, 10.0), maxwell(2.5e5, 100.0)}};
  const Diagnosis found = checkedTable(model, table);
  EXPECT_THAT(found.answer.verdict, testing::AnyOf(Verdict::named, Verdict::partly));
  EXPECT_THAT(found.answer.effects, testing::ElementsAre("temperature"));
  EXPECT_THAT(found.gaps.noise_source, HasSubstr("the residual of a master curve through the table"));
}

TEST(TableDiagnosis, ProposesARowThatIsNew) {
  EXPECT_THAT(ofFrictionTable().next.text, testing::AnyOf(HasSubstr("Measure a row at"), HasSubstr("Record a log")));
  const Diagnosis none = checkedTable(without(kZener), Laboratory(1).table(without(kZener)));
  EXPECT_THAT(none.next.text,
              HasSubstr("No further row is needed for the effects that a table can show. Record a log"));
}

TEST(TableDiagnosis, WritesTheReport) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "table_report";
  std::filesystem::remove_all(folder);
  writeReport(ofFrictionTable(), folder.string());
  EXPECT_THAT(contentOf(folder / "report.html"),
              HasSubstr(fmt::format("All {} rows, measured and simulated", frictionTable().points.size())));
  for (const char* name : {"report.json", "report.html", "augmented.yaml", "figure_stiffness.csv",
                           "figure_loss_angle.csv", "figure_where.csv"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  }
  const auto report = nlohmann::json::parse(contentOf(folder / "report.json"));
  EXPECT_EQ(report.at("schema"), "rubber_suspension/gap_report/1");
  EXPECT_EQ(report.at("verdict"), "named");
  EXPECT_EQ(report.at("table").at("rows").size(), frictionTable().points.size());
  EXPECT_THAT(report.at("table").at("never_shown"), Contains("stress_softening"));
  EXPECT_EQ(report.at("where").size(), 2 * frictionTable().points.size());
  std::filesystem::remove_all(folder);
}

TEST(Scatter, IsWhatTheLaboratoryStates) {
  EXPECT_EQ(table::scatterOf(Laboratory(1).table(without(kZener)).points, 0.02).level, 0.02);
}

// The upper limit of a one-sided 84 % interval exceeds the truth in 84 % of tables, so in at least 25 of 40 (99.9 %).
// With 8 free complex numbers the limit is 1.27 times the estimate, plus the error of the smooth surface.
TEST(Scatter, CoversTheNoiseOfRepeatsAndOfSmoothTables) {
  const io::ComponentDescription truth = with(kZener, kFriction);
  const fit::MeasuredTable exact = Laboratory(1, 0.0).table(truth);
  for (const int repeats : {1, 3}) {
    int above = 0;
    double mean = 0.0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
      Laboratory laboratory(seed);
      std::vector<fit::TablePoint> points;
      for (int i = 0; i < repeats; ++i) {
        for (const fit::TablePoint& point : exact.points) {
          points.push_back(laboratory.measured(point));
        }
      }
      const table::Scatter scatter = table::scatterOf(points, std::nullopt);
      EXPECT_THAT(scatter.source, HasSubstr(repeats > 1 ? "repeated rows" : "smooth surface"));
      above += scatter.level > kNoise ? 1 : 0;
      mean += scatter.level / 40.0;
    }
    EXPECT_GE(above, 25) << repeats;
    EXPECT_LT(mean, 1.6 * kNoise) << repeats;
  }
}

TEST(Scatter, IsAssumedWhereNothingTellsIt) {
  std::vector<fit::TablePoint> points = Laboratory(1).table(without(kZener)).points;
  points = {points[0], points[2], points[19], points[22]};
  const table::Scatter scatter = table::scatterOf(points, std::nullopt);
  EXPECT_EQ(scatter.level, 0.01);
  EXPECT_THAT(scatter.source, HasSubstr("assumed"));
}

}  // namespace
}  // namespace rubber_suspension::diagnosis
