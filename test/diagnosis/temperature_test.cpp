// The temperature in a diagnosis: a column that explains the gap, one that says nothing, none; a component that follows
// it already. The rig is a Zener solid whose rate and stiffness are shifted by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "checked_diagnosis.h"
#include "diagnosis/candidate/registry.h"
#include "diagnosis/report/temperature_note.h"
#include "diagnosis/workings.h"
#include "rig.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/gap/replay.h"

namespace rubber_suspension {
namespace {

using ::testing::HasSubstr;

using TemperatureOf = std::function<double(double time)>;

double room(double /*time*/) { return 20.0; }

// The log of runRig, its force computed again: relaxation by WLF (natural rubber at 20 degC), stiffness by T/T_0.
log::Log runAt(const std::string& name, unsigned seed, const TemperatureOf& temperature) {
  log::Log log = runRig(
      name, seed, [](double, double, double) { return 0.0; }, 0.0);
  const auto elements = rigComponent().allElements();
  const double spring = elements[0].value("stiffness");
  const double stiffness = elements[1].value("stiffness");
  const double rate = 2.0 * element::kPi * elements[1].value("break_frequency");
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0.0, 10.0);
  constexpr double kStep = 0.004;
  double relaxing = 0.0;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const double celsius = temperature(log.time(i));
    const double above = celsius - 20.0;
    const double shifted = rate * std::pow(10.0, 6.13 * above / (146.8 + above));
    const double decay = std::exp(-kStep * shifted);
    const double increment = i == 0 ? 0.0 : log.displacement[i] - log.displacement[i - 1];
    relaxing = decay * relaxing + stiffness * increment / (kStep * shifted) * (1.0 - decay);
    log.temperature.push_back(celsius);
    log.force[i] = (spring * log.displacement[i] + relaxing) * (celsius + 273.15) / 293.15 + normal(generator);
  }
  return log;
}

std::vector<log::Log> warmingLogs() {
  return {runAt("cold", 1, [](double time) { return 5.0 + 0.8 * time; }),
          runAt("warm", 2, [](double time) { return 35.0 + 0.5 * time; })};
}

log::Log unseenLog() {
  return runAt("unseen", 3, [](double time) { return 40.0 - 1.2 * time; });
}

const diagnosis::CandidateResult& temperatureOf(const diagnosis::Diagnosis& result) {
  return *std::find_if(result.candidates.begin(), result.candidates.end(),
                       [](const diagnosis::CandidateResult& candidate) { return candidate.effect == "temperature"; });
}

TEST(TemperatureEffect, IsNamedWhereTheColumnExplainsTheGap) {
  const diagnosis::Diagnosis result = checkedDiagnosis(rigComponent(), warmingLogs(), {unseenLog()});
  ASSERT_FALSE(result.effects.empty()) << result.sentence;
  EXPECT_EQ(result.effects.front(), "temperature") << result.sentence;
  EXPECT_GT(result.closed, 0.9);
  EXPECT_TRUE(temperatureOf(result).testable);
  // WLF's slope at 20 degC is ln(10) R T^2 C_1/C_2 = 69 kJ/mol; from 5 to 45 degC it falls from 79 to 58.
  const double energy = temperatureOf(result).parameters.at("activation_energy");
  EXPECT_GT(energy, 50e3);
  EXPECT_LT(energy, 90e3);
  // The node runs what was found: its replay has the gap of the report.
  const log::Log unseen = unseenLog();
  const double replayed = gap::relativeGap(unseen.force, gap::replay(result.augmented.makeComponent(), unseen).force);
  EXPECT_NEAR(replayed, result.gap_as_recorded.augmented, 1e-3);
  const auto read = io::parseComponentFile(io::toYaml({result.augmented}), "augmented").front();
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
  EXPECT_EQ(std::count(result.effects.begin(), result.effects.end(), "temperature"), 0);
  EXPECT_TRUE(temperatureOf(result).add.empty());
  for (const std::string& effect : result.effects) {
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
  EXPECT_EQ(result.verdict, "none") << result.sentence;
}

TEST(TemperatureEffect, RefusesATemperatureAtWhichTheShiftDoesNotHold) {
  io::ComponentDescription component = rigComponent();
  component.temperature = {"wlf_shift", {{"c1", {17.44}}, {"c2", {51.6}}, {"reference", {20.0}}}};
  std::vector<log::Log> logs = warmingLogs();
  logs[1].temperature[17] = -60.0;
  try {
    diagnosis::diagnose(component, logs, {});
    FAIL() << "accepted";
  } catch (const log::LogError& error) {
    EXPECT_THAT(error.what(), HasSubstr("warm: sample 18: temperature -60 degC is out of range; accepted: at least"));
  }
}

std::size_t termsFor(const std::vector<log::Log>& logs) {
  std::vector<log::Record> records;
  std::transform(logs.begin(), logs.end(), std::back_inserter(records), log::makeRecord);
  const auto all = diagnosis::candidates(fit::summarise(records));
  return std::find_if(all.begin(), all.end(), [](const fit::Candidate& c) { return c.effect == "temperature"; })
      ->terms.size();
}

TEST(TemperatureEffect, NeedsATemperatureThatMovesInLogsThatAllHaveOne) {
  EXPECT_EQ(termsFor(warmingLogs()), 3U) << "rates, stiffness, and the foot of the glass transition";
  EXPECT_EQ(termsFor({runAt("one", 1, room), runAt("two", 2, room)}), 0U);
  std::vector<log::Log> one_without = warmingLogs();
  one_without[1].temperature.clear();
  EXPECT_EQ(termsFor(one_without), 0U);
}

// An uneven time base is resampled, the temperature with it.
TEST(TemperatureEffect, IsResampledWithTheLog) {
  log::Log log = runAt("uneven", 1, [](double time) { return 5.0 + 0.8 * time; });
  for (std::size_t i = 0; i < log.size(); i += 2) {
    log.stamp[i] += 1000000;
  }
  const log::Record record = log::makeRecord(log);
  ASSERT_EQ(record.temperature.size(), record.size());
  // Moved by a millisecond of a ramp of 0.8 K/s, and linear in between.
  EXPECT_NEAR(record.temperature[record.size() / 2], 5.0 + 0.8 * 0.5 * record.duration(), 0.8 * 2e-3 + 0.8 * record.dt);
}

TEST(TemperatureNote, StandsWithHeatingAndSofteningOfLogsWithoutATemperature) {
  fit::Excitation excitation;
  EXPECT_EQ(diagnosis::temperatureNote({"friction"}, excitation), "");
  EXPECT_THAT(diagnosis::temperatureNote({"friction", "self_heating"}, excitation),
              HasSubstr("self_heating is not certain"));
  EXPECT_THAT(diagnosis::temperatureNote({"stress_softening"}, excitation), HasSubstr("column temperature_degC"));
  excitation.has_temperature = true;
  EXPECT_EQ(diagnosis::temperatureNote({"self_heating"}, excitation), "");
}

}  // namespace
}  // namespace rubber_suspension
