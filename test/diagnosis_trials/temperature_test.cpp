// Whole diagnoses: a temperature explains the gap, logs have no temperature, a component follows it already.
#include "diagnosis/checked_diagnosis.h"
#include "diagnosis/warm_rig.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/gap/replay.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

const diagnosis::CandidateResult& temperatureOf(const diagnosis::Diagnosis& result) {
  return *std::find_if(result.candidates.begin(), result.candidates.end(),
                       [](const diagnosis::CandidateResult& candidate) { return candidate.effect == "temperature"; });
}

TEST(TemperatureEffect, IsNamedWhereTheColumnExplainsTheGap) {
  const diagnosis::Diagnosis result = checkedDiagnosis(rigComponent(), warmingLogs(), {unseenLog()});
  ASSERT_FALSE(result.answer.effects.empty()) << result.sentence;
  EXPECT_EQ(result.answer.effects.front(), "temperature") << result.sentence;
  EXPECT_GT(result.gaps.closed, 0.9);
  EXPECT_TRUE(temperatureOf(result).testable);
  // At 20 degC, the slope of WLF is ln(10) C_1/C_2 = 0.096/K, an activation energy of 69 kJ/mol. The energy falls from
  // 79 to 58 kJ/mol between 5 and 45 degC, so the test accepts a fit of 50 to 90.
  const auto slope = temperatureOf(result).parameters.lower_bound("change_of_rates");
  ASSERT_NE(slope, temperatureOf(result).parameters.end());
  constexpr double kGas = 8.314462618;  // [J/(mol K)]
  const double energy = slope->second * kGas * 293.15 * 293.15;
  EXPECT_THAT(slope->first, HasSubstr("change_of_rates_at_"));
  EXPECT_GT(energy, 50e3);
  EXPECT_LT(energy, 90e3);
  // Replaying the written component reproduces the gap in the report.
  const log::Log unseen = unseenLog();
  const double replayed =
      gap::relativeGap(unseen.force, gap::replay(result.law.augmented.makeComponent(), unseen).force);
  EXPECT_NEAR(replayed, result.gap_as_recorded.augmented, 1e-3);
  const auto read = componentOf(io::toYaml({result.law.augmented}));
  EXPECT_TRUE(read.makeComponent().shiftsWithTemperature());
}

TEST(TemperatureEffect, CannotBeTestedWithoutTheColumn) {
  std::vector<log::Log> logs = warmingLogs();
  for (log::Log& log : logs) {
    log.temperature.clear();
  }
  const diagnosis::Diagnosis result = checkedDiagnosis(rigComponent(), logs, {});
  EXPECT_FALSE(temperatureOf(result).testable);
  EXPECT_EQ(temperatureOf(result).probability, 0.0);
  EXPECT_EQ(std::count(result.answer.effects.begin(), result.answer.effects.end(), "temperature"), 0);
  EXPECT_TRUE(temperatureOf(result).add.empty());
  for (const std::string& effect : result.answer.effects) {
    if (effect == "self_heating" || effect == "stress_softening") {
      EXPECT_THAT(result.sentence, HasSubstr("temperature_degC"));
    }
  }
}

TEST(TemperatureEffect, AComponentThatFollowsTheTemperatureHasNoGap) {
  io::ComponentDescription component = rigComponent();
  component.temperature = {"wlf_shift",
                           {{"c1", {6.13}}, {"c2", {146.8}}, {"reference", {20.0}}, {"vertical", {1.0 / 293.15}}}};
  const diagnosis::Diagnosis result = checkedDiagnosis(component, warmingLogs(), {unseenLog()});
  EXPECT_EQ(result.answer.verdict, diagnosis::Verdict::none) << result.sentence;
}

}  // namespace
}  // namespace rubber_suspension
