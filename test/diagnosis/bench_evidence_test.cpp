// The report's figure of logs with a wrong sign, unit, column or component shows them as recorded and as corrected.
#include "diagnosis/prepare/bench_evidence.h"

#include "diagnosis/report/report_figures.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "shared_runs.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

log::Log goodLog() { return runRig("good", 1, nothing); }

diagnosis::Diagnosis diagnose(const log::Log& log) { return diagnosis::diagnose(rigComponent(), {log}, {}); }

// Returns the RMS of measured minus simulated force in a panel, divided by the RMS of the measured force.
double distance(const io::Axes& axes) {
  double difference = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < axes.curves.at(0).y.size(); ++i) {
    difference += std::pow(axes.curves[0].y[i] - axes.curves.at(1).y[i], 2);
    all += std::pow(axes.curves[0].y[i], 2);
  }
  return std::sqrt(difference / all);
}

// Expects two panels: their curves differ as recorded, and agree after the correction that the panel's title names.
void expectCorrected(const log::Log& log, const std::string& correction) {
  const diagnosis::Diagnosis result = diagnose(log);
  ASSERT_EQ(result.answer.verdict, diagnosis::Verdict::check_bench) << correction;
  const auto figures = diagnosis::report::reportFigures(result);
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].name, "bench");
  ASSERT_EQ(figures[0].figure.axes.size(), 2U) << correction;
  EXPECT_THAT(figures[0].figure.axes[0].title, HasSubstr("as it is"));
  EXPECT_THAT(figures[0].figure.axes[1].title, HasSubstr(correction));
  EXPECT_GT(distance(figures[0].figure.axes[0]), 0.5) << correction;
  EXPECT_LT(distance(figures[0].figure.axes[1]), 0.05) << correction;  // the rig's noise is 1 % of the force
  EXPECT_THAT(diagnosis::toJson(result), HasSubstr("figure_bench.csv"));
}

TEST(BenchEvidence, ShowsAReversedSign) {
  log::Log log = goodLog();
  for (double& force : log.force) {
    force *= -1.0;
  }
  expectCorrected(log, "force times -1");
}

TEST(BenchEvidence, ShowsAWrongUnit) {
  log::Log log = goodLog();
  for (double& force : log.force) {
    force *= 1000.0;
  }
  expectCorrected(log, "force divided by 1000");
}

TEST(BenchEvidence, ProposesNothingForAnotherComponent) {
  log::Log log = goodLog();
  for (double& force : log.force) {
    force *= 6.0;
  }
  const diagnosis::Diagnosis result = diagnose(log);
  ASSERT_EQ(result.answer.verdict, diagnosis::Verdict::check_bench);
  const auto figures = diagnosis::report::reportFigures(result);
  ASSERT_EQ(figures.at(0).figure.axes.size(), 1U);
  const std::string json = toJson(result);
  for (const char* key : {"\"as_configured\": null", "\"noise_floor\": null", "\"fraction\": null", "\"none\": null"}) {
    EXPECT_THAT(json, HasSubstr(key)) << "nothing was judged";
  }
}

TEST(BenchEvidence, IsNotForLogsThatAreWhatTheySay) { EXPECT_FALSE(ofOneLog().bench_evidence); }

}  // namespace
}  // namespace rubber_suspension
