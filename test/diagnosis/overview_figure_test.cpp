// The figure of `diagnose --plot` has panels that show how large the gap is and where, with the findings as titles.
#include <nlohmann/json.hpp>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/report/report_figures.h"
#include "rubber_suspension/element/constants.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

// Returns a diagnosis with a sine log, whose model is off by 100 N before the augmentation and exact after it.
diagnosis::Diagnosis madeUp(const std::string& log = "sine") {
  constexpr Eigen::Index kSize = 2000;
  log::Record record;
  record.name = log;
  record.dt = 1e-3;
  record.displacement = 1e-3 * (2.0 * element::kPi * Eigen::VectorXd::LinSpaced(kSize, 0.0, 2.0)).array().sin();
  record.raw_displacement = record.displacement;
  record.force = 1e6 * record.displacement;
  record.force_deviation = 1e3 / std::sqrt(2.0);
  diagnosis::Diagnosis diagnosis;
  diagnosis.component = "bush";
  diagnosis.answer.verdict = diagnosis::Verdict::named;
  diagnosis.answer.effects = {"friction", "creep"};
  auto workings = std::make_shared<diagnosis::Workings>();
  workings->simulated.records = {record};
  workings->simulated.training = 1;
  workings->simulated.configured = {record.force.array() + 100.0};
  workings->simulated.re_estimated = workings->simulated.configured;
  workings->simulated.augmented = {record.force};
  diagnosis.workings = workings;
  return diagnosis;
}

TEST(OverviewFigure, ShowsLoopsResidualsAndTime) {
  const io::Figure figure = diagnosis::report::overviewFigure(madeUp());
  EXPECT_EQ(figure.title, "bush: named: friction, creep");
  ASSERT_EQ(figure.axes.size(), 3U);  // without cells there is no map
  EXPECT_EQ(figure.axes[0].title, "Force over displacement\nsine, 0 to 2 s");
  EXPECT_NEAR(figure.axes[1].curves[0].y[0], -0.1, 1e-12);  // measured minus configured force [kN]
  EXPECT_NEAR(figure.axes[1].curves[2].y[0], 0.0, 1e-12);
}

// Labels state the units of a rotation. The name of a log stays unchanged even if it resembles a unit.
TEST(OverviewFigure, HasUnitsOfARotationAndNamesAsTheyAre) {
  diagnosis::Diagnosis diagnosis = madeUp("run 3 N");
  diagnosis.turns = true;
  const auto figures = diagnosis::report::reportFigures(diagnosis);
  EXPECT_EQ(figures[0].figure.axes[0].title, "run 3 N, 0 to 2 s");
  EXPECT_EQ(figures[0].figure.axes[0].x_label, "displacement [mrad]");
  EXPECT_THAT(diagnosis::report::figureCsv(figures[0].figure),
              testing::StartsWith("curve,panel,displacement_mrad,force_kN_m\n"));
  diagnosis.logs.admission.resize(1);
  diagnosis.logs.admission[0].log = "run 3 N";
  diagnosis.rig_findings.resize(1);
  diagnosis.rig_findings[0].log = "run 3 N";
  diagnosis.rig_findings[0].finding = measurement::finding::kForceZero;
  diagnosis.rig_findings[0].value = 31.0;
  diagnosis.rig_findings[0].interval_95 = {29.0, 33.0};
  diagnosis.rig_findings[0].unit = "N m";
  diagnosis.workings.reset();
  const auto report = nlohmann::json::parse(toJson(diagnosis));
  EXPECT_EQ(report.at("admission").at(0).at("log"), "run 3 N");
  EXPECT_EQ(report.at("units").at("m"), "rad");
  EXPECT_EQ(report.at("rig_findings").at(0).at("value_text"), "31 N m (29 N m to 33 N m)");
}

TEST(OverviewFigure, MapsTheGapWhereItIsKnown) {
  diagnosis::Diagnosis diagnosis = madeUp();
  diagnosis.where.before = {{"sine", {1.0, 2.0}, {3.16e-4, 1e-3}, gap::Quantity::stiffness, 0.7, 10.0},
                            {"sine", {1.0, 2.0}, {3.16e-4, 1e-3}, gap::Quantity::loss, 0.2, 10.0},
                            {"sine", {0.0, 0.0}, {0.0, 0.0}, gap::Quantity::mean, 0.1, 10.0}};
  const io::Figure figure = diagnosis::report::overviewFigure(diagnosis);
  ASSERT_EQ(figure.axes.size(), 4U);
  ASSERT_EQ(figure.axes[1].maps.size(), 1U);
  EXPECT_NEAR(figure.axes[1].maps[0].values.at(0), 90.0, 1e-9);  // sum of stiffness and loss [%]
}

}  // namespace
}  // namespace rubber_suspension
