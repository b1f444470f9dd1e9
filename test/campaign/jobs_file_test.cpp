// A jobs file is read, or all its errors are reported at once, each with line, key, value and accepted values.
#include "campaign/jobs_file.h"

#include "support/test.h"

namespace rubber_suspension {
namespace {

std::vector<std::string> problemsOf(const std::string& text) {
  std::vector<std::string> problems;
  campaign::parseJobsFile(text, "jobs.yaml", problems);
  return problems;
}

TEST(JobsFile, IsRead) {
  std::vector<std::string> problems;
  const std::vector<campaign::JobGroup> groups = campaign::parseJobsFile(
      "settings: {reports: none, sampling_rate: 1000}\n"
      "jobs:\n"
      "  fleet:\n"
      "    command: diagnose\n"
      "    folders: trucks/*\n"
      "    config: component.yaml\n"
      "    log: [sweep*.csv, track.csv]\n"
      "    hold_out: last.csv\n"
      "    rig: {gain: 1 %}\n"
      "  study:\n"
      "    command: replay\n"
      "    config: bush.yaml\n"
      "    component: bush\n"
      "    log: track.csv\n"
      "    reports: data\n"
      "    monte_carlo: {runs: 10, seed: 3, tolerances: {static_stiffness: {normal: 5 %}, dynamic_stiffness: {uniform: "
      "0.1 kN/mm}}}\n",
      "jobs.yaml", problems);
  EXPECT_THAT(problems, IsEmpty());
  ASSERT_EQ(groups.size(), 2U);
  const campaign::JobGroup& fleet = groups[0];
  EXPECT_EQ(fleet.name, "fleet");
  EXPECT_EQ(fleet.line, 3);
  EXPECT_THAT(fleet.logs, ElementsAre("sweep*.csv", "track.csv"));
  EXPECT_EQ(fleet.options.reports, campaign::Reports::none);
  EXPECT_EQ(fleet.options.sampling_rate, 1000.0);
  EXPECT_EQ(fleet.options.rig.at("gain"), "1 %");
  const campaign::JobGroup& study = groups[1];
  EXPECT_EQ(study.options.reports, campaign::Reports::data);
  ASSERT_TRUE(study.monte_carlo);
  EXPECT_EQ(study.monte_carlo->runs, 10U);
  EXPECT_EQ(study.monte_carlo->tolerances.at("static_stiffness").shape, campaign::Tolerance::Shape::normal);
  EXPECT_DOUBLE_EQ(study.monte_carlo->tolerances.at("static_stiffness").width, 0.05);
  EXPECT_DOUBLE_EQ(study.monte_carlo->tolerances.at("dynamic_stiffness").width, 1e5);
  EXPECT_FALSE(study.monte_carlo->tolerances.at("dynamic_stiffness").is_share);
}

TEST(JobsFile, TellsEveryProblemAtOnce) {
  EXPECT_THAT(
      problemsOf("settings: {reports: all}\n"
                 "jobs:\n"
                 "  one:\n"
                 "    command: diagnoze\n"
                 "    config: c.yaml\n"
                 "    logs: a.csv\n"
                 "  two:\n"
                 "    command: replay\n"
                 "    config: c.yaml\n"
                 "    log: a.csv\n"
                 "    hold_out: b.csv\n"
                 "    monte_carlo: {runs: 1.5, tolerances: {static_stiffness: {uniform: 5 kg}}}\n"),
      ElementsAre(AllOf(HasSubstr("jobs.yaml:1: settings.reports: 'all'"), HasSubstr("accepted: none, data, full")),
                  AllOf(HasSubstr("jobs.yaml:6: jobs.one.logs: unknown key (did you mean 'log'?); accepted: command,")),
                  AllOf(HasSubstr("jobs.yaml:4: jobs.one.command: 'diagnoze'"),
                        HasSubstr("accepted: diagnose, estimate, replay")),
                  HasSubstr("jobs.one.log: missing; accepted: text"),
                  HasSubstr("jobs.two.monte_carlo.runs: '1.5'; accepted: a whole number from 1"),
                  HasSubstr("jobs.two.monte_carlo.seed: missing; accepted: a whole number from 0"),
                  AllOf(HasSubstr("jobs.two.monte_carlo.tolerances.static_stiffness"), HasSubstr("5 kg")),
                  AllOf(HasSubstr("jobs.yaml:11: jobs.two.hold_out: has no effect on the command replay"))));
}

TEST(JobsFile, EvidenceNeedsAReportAndADiagnosis) {
  std::vector<std::string> problems;
  const std::vector<campaign::JobGroup> groups = campaign::parseJobsFile(
      "jobs:\n  a: {command: diagnose, config: c, log: l, evidence: true, test_rig: hexapod}\n", "jobs.yaml", problems);
  EXPECT_THAT(problems, IsEmpty());
  EXPECT_TRUE(groups.at(0).options.evidence);
  EXPECT_EQ(groups.at(0).test_rig, "hexapod");
  EXPECT_THAT(
      problemsOf("settings: {reports: none}\njobs:\n  a: {command: diagnose, config: c, log: l, evidence: true}\n"),
      ElementsAre(HasSubstr("reports: none writes no folder; accepted: reports: data, full")));
  EXPECT_THAT(problemsOf("jobs:\n  a: {command: replay, config: c, log: l, evidence: true, test_rig: hexapod}\n"),
              ElementsAre(HasSubstr("evidence: has no effect on the command replay"),
                          HasSubstr("test_rig: has no effect on the command replay")));
}

TEST(JobsFile, ExcludesKnownEffects) {
  const std::string entry = "jobs:\n  a: {command: diagnose, config: c, log: l, exclude: [free_play, ";
  std::vector<std::string> problems;
  const std::vector<campaign::JobGroup> groups = campaign::parseJobsFile(entry + "backlash]}\n", "jobs.yaml", problems);
  EXPECT_THAT(problems, IsEmpty());
  EXPECT_THAT(groups.at(0).options.exclude, ElementsAre("free_play", "backlash"));
  EXPECT_THAT(problemsOf(entry + "slack]}\n"), ElementsAre(HasSubstr("exclude: 'slack' is not an effect")));
}

TEST(JobsFile, TheSamplingRateHasOneName) {
  EXPECT_THAT(problemsOf("settings: {rate: 1000}\njobs:\n  a:\n    command: replay\n    config: c\n    log: l\n"),
              ElementsAre("jobs.yaml:1: settings.rate: unknown key (did you mean 'sampling_rate'?); accepted: reports, "
                          "evidence, columns, unit, sampling_rate, decimal, segment, bridge, sentinel, clock, "
                          "accept_units, large, without_rig, rig, exclude, hold, starts"));
}

TEST(JobsFile, RefusesWhatIsNone) {
  for (const char* text : {"", "jobs", "[1, 2]", "jobs: {}", "jobs: [a]", "jobs: {a: 1}", "a: {b: [",
                           "jobs: {a: {}}\n---\n", "? [x]\n: 1\n", "jobs: {? {a: 1} : 2}", "jobs:\n  a:\n  a:\n"}) {
    EXPECT_THAT(problemsOf(text), ::testing::Not(IsEmpty())) << text;
  }
  EXPECT_THAT(problemsOf("jobs: " + std::string(100000, '[')), ElementsAre(HasSubstr("the file is nested too deeply")));
}

TEST(JobsFile, RefusesATolerancesThatIsNone) {
  const auto problem = [](const std::string& tolerance) {
    return problemsOf(
        "jobs:\n  a:\n    command: replay\n    config: c\n    log: l\n    monte_carlo:\n      runs: 1\n"
        "      seed: 1\n      tolerances: " +
        tolerance + "\n");
  };
  EXPECT_THAT(problem("{static_stiffness: {uniform: 100 %}}"), ElementsAre(HasSubstr("below 100 %")));
  EXPECT_THAT(problem("{static_stiffness: {uniform: -1 %}}"), ElementsAre(HasSubstr("greater than 0")));
  EXPECT_THAT(problem("{static_stiffness: {uniform: nan}}"), ElementsAre(HasSubstr("greater than 0")));
  EXPECT_THAT(problem("{static_stiffness: {uniform: 1 %, normal: 1 %}}"),
              ElementsAre(HasSubstr("either uniform or normal")));
  EXPECT_THAT(problem("{static_stifness: {uniform: 1 %}}"),
              ElementsAre(HasSubstr("unknown key (did you mean 'static_stiffness'?); accepted: ")));
  EXPECT_THAT(problem("{}"), ElementsAre(HasSubstr("missing or empty")));
}

}  // namespace
}  // namespace rubber_suspension
