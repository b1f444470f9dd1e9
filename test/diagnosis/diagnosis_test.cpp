// The diagnosis from logs to a verdict, on rigs that share no code with the candidates.
#include "rubber_suspension/diagnosis/diagnosis.h"

#include <nlohmann/json.hpp>

#include "diagnosis/hypotheses/workings.h"
#include "rubber_suspension/gap/replay.h"
#include "shared_runs.h"
#include "support/scratch_folder.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

TEST(Diagnosis, FindsNoGapWhereThereIsNone) {
  const diagnosis::Diagnosis& result = ofNothing();
  EXPECT_EQ(result.answer.verdict, diagnosis::Verdict::none);
  EXPECT_TRUE(result.answer.effects.empty());
  // The noise floor is estimated from the median of some hundred spectral lines of white noise of 20 N.
  double standard_deviation = 0.0;
  for (const log::Record& record : result.workings->simulated.records) {
    standard_deviation = std::max(standard_deviation, record.force_deviation);
  }
  EXPECT_NEAR(result.gaps.unseen.noise_floor, 20.0 / standard_deviation, 0.15 * 20.0 / standard_deviation);
}

TEST(Diagnosis, CallsWrongValuesAParameterError) {
  io::ComponentDescription wrong = rigComponent();
  estimation::Specification specification = wrong.specification();
  specification.set("static_stiffness", 0.85e6);
  specification.set("break_frequency", 4.0);
  wrong.specify(specification);
  const diagnosis::Diagnosis result = diagnoseRig(nothing, wrong);
  EXPECT_EQ(result.answer.verdict, diagnosis::Verdict::parameter_error);
  EXPECT_TRUE(result.answer.effects.empty());
  EXPECT_GT(result.gaps.unseen.as_configured, 5.0 * result.gaps.unseen.noise_floor);
  EXPECT_LT(result.gaps.unseen.re_estimated, 1.1 * result.gaps.unseen.noise_floor);  // this floor is an estimate
}

TEST(Diagnosis, NamesAStopAndClosesTheGapOnAnUnseenLog) {
  const diagnosis::Diagnosis& result = ofAStop();
  ASSERT_FALSE(result.answer.effects.empty()) << result.sentence;
  EXPECT_EQ(result.answer.effects.front(), "bump_stop");
  EXPECT_GT(result.gaps.closed, 0.8);
  EXPECT_LE(result.gaps.closed_interval[0], result.gaps.closed);
  EXPECT_GE(result.gaps.closed_interval[1], result.gaps.closed);
}

TEST(Diagnosis, RefusesHumOfADriveThatStartsAndStops) {
  const diagnosis::Diagnosis& result = ofHum();
  EXPECT_EQ(result.answer.verdict, diagnosis::Verdict::unknown);
  EXPECT_TRUE(result.answer.effects.empty());
}

TEST(Diagnosis, SharesOfTheMapAddUpToOne) {
  const diagnosis::Diagnosis& result = ofAStop();
  const double sum = std::accumulate(result.where.before.begin(), result.where.before.end(), 0.0,
                                     [](double total, const gap::GapCell& cell) { return total + cell.share; });
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(Diagnosis, ReplayOfTheAugmentedFileGivesTheClaimedGap) {
  const log::Log unseen = runRig("unseen", 3, stop);
  const diagnosis::Diagnosis& result = ofAStop();
  const auto components = io::parseComponentFile(io::toYaml({result.law.augmented}), "augmented.yaml");
  const gap::Replay replayed = gap::replay(components.front().makeComponent(), unseen);
  const Eigen::Map<const Eigen::VectorXd> measured(unseen.force.data(), static_cast<Eigen::Index>(unseen.size()));
  const Eigen::Map<const Eigen::VectorXd> simulated(replayed.force.data(), measured.size());
  const double standard_deviation = std::sqrt((measured.array() - measured.mean()).square().mean());
  const double gap =
      std::sqrt((measured - simulated).squaredNorm() / static_cast<double>(measured.size())) / standard_deviation;
  EXPECT_NEAR(gap, result.gap_as_recorded.augmented, 1e-9);
  // The gap of the held-out log excludes an offset of the force and the transient at the start.
  EXPECT_NEAR(gap, result.gaps.unseen.augmented, 0.05 * gap);
}

TEST(Diagnosis, WritesAReportOfTheAgreedSchema) {
  const ScratchFolder folder;
  diagnosis::writeReport(ofAStop(), folder.path());
  std::ifstream stream(folder.path("report.json"));
  const auto report = nlohmann::json::parse(stream);
  EXPECT_EQ(report.at("schema"), "rubber_suspension/gap_report/1");
  for (const char* key :
       {"component", "verdict", "effects", "gap", "closed", "confounded", "candidates", "where", "next_experiment"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  for (const char* key : {"as_configured", "re_estimated", "augmented", "noise_floor"}) {
    EXPECT_TRUE(report.at("gap").at(key).is_number()) << key;
  }
  const auto& posterior = report.at("posterior");
  EXPECT_NEAR(posterior.at("none").get<double>() + posterior.at("parameter_error").get<double>() +
                  posterior.at("effects").get<double>() + posterior.at("none_of_these").get<double>(),
              1.0, 1e-6);
  double sum = 1.0 - posterior.at("effects").get<double>();
  for (const auto& candidate : report.at("candidates")) {
    sum += candidate.at("probability").get<double>();
    EXPECT_EQ(candidate.at("interval_95").size(), 2u);
    EXPECT_TRUE(candidate.at("testable").is_boolean());
  }
  EXPECT_GT(sum, 0.99);
  EXPECT_TRUE(std::filesystem::exists(folder.path("report.html")));
  EXPECT_NO_THROW(io::loadComponentFile(folder.path("augmented.yaml")));
}

TEST(Diagnosis, RefusesALogWithoutForce) {
  log::Log log = runRig("one", 1, nothing);
  log.force.clear();
  EXPECT_THROW(diagnosis::diagnose(rigComponent(), {log}, {}), log::LogError);
}

// An excluded effect is not named, but the report states how much it would explain. Here both causes of the gap are
// excluded.
TEST(Excluded, IsNotNamedButTold) {
  io::ComponentDescription component = rigComponent();
  component.excluded_effects = {"bump_stop", "friction"};
  const auto both = [friction = rigFriction()](double time, double z, double rate) {
    return friction(time, z, rate) + linearStop(time, z, rate);
  };
  const diagnosis::Diagnosis result = diagnoseRig(both, component);
  EXPECT_THAT(result.answer.effects,
              ::testing::Not(::testing::AnyOf(::testing::Contains("bump_stop"), ::testing::Contains("friction"))));
  ASSERT_EQ(result.answer.excluded.size(), 2);
  for (const diagnosis::ExcludedEffect& one : result.answer.excluded) {
    EXPECT_GT(one.probability_otherwise, 0.5) << one.effect;
  }
  EXPECT_THAT(
      result.sentence,
      ::testing::HasSubstr(
          "Effects excluded by the component file: without this exclusion, the probability of friction would be "));
  EXPECT_LT(result.gaps.unseen.noise_floor, 0.5 * result.gaps.unseen.augmented);
  EXPECT_EQ(result.law.augmented.excluded_effects, component.excluded_effects);
}

}  // namespace
}  // namespace rubber_suspension
