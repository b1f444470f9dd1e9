// The temperature column in a diagnosis: constant, out of range, or missing.
#include "diagnosis/effect.h"
#include "diagnosis/words/sentence.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/log/record.h"
#include "support/test.h"
#include "warm_rig.h"

namespace rubber_suspension {
namespace {

double room(double /*time*/) { return 20.0; }

TEST(TemperatureEffect, RefusesATemperatureAtWhichTheShiftDoesNotHold) {
  io::ComponentDescription component = rigComponent();
  component.temperature = {"wlf_shift", {{"c1", {17.44}}, {"c2", {51.6}}, {"reference", {20.0}}}};
  std::vector<log::Log> logs = warmingLogs();
  logs[1].temperature[17] = -60.0;
  EXPECT_THAT(messageOf<log::LogError>([&] { diagnosis::diagnose(component, logs, {}); }),
              HasSubstr("warm: sample 18: temperature -60 degC is out of range; accepted: at least"));
}

std::size_t termsFor(const std::vector<log::Log>& logs) {
  std::vector<gap::PreparedRecord> records;
  for (const log::Log& log : logs) {
    records.emplace_back(log::makeRecord(log));
  }
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

// Resampling an uneven time base resamples the temperature as well.
TEST(TemperatureEffect, IsResampledWithTheLog) {
  log::Log log = runAt("uneven", 1, [](double time) { return 5.0 + 0.8 * time; });
  for (std::size_t i = 0; i < log.size(); i += 2) {
    log.stamp[i] += 1000000;
  }
  const log::Record record = log::makeRecord(log);
  ASSERT_EQ(record.temperature.size(), record.size());
  // The tolerance covers shifts of the stamps by 1 ms on a ramp of 0.8 K/s.
  EXPECT_NEAR(record.temperature[record.size() / 2], 5.0 + 0.8 * 0.5 * record.duration(), 0.8 * 2e-3 + 0.8 * record.dt);
}

TEST(TemperatureNote, StandsWithHeatingAndSofteningOfLogsWithoutATemperature) {
  fit::Excitation excitation;
  EXPECT_EQ(diagnosis::words::temperatureNote({"friction"}, excitation), "");
  EXPECT_THAT(diagnosis::words::temperatureNote({"friction", "self_heating"}, excitation),
              HasSubstr("self_heating is not certain"));
  EXPECT_THAT(diagnosis::words::temperatureNote({"stress_softening"}, excitation),
              HasSubstr("column temperature_degC"));
  excitation.has_temperature = true;
  EXPECT_EQ(diagnosis::words::temperatureNote({"self_heating"}, excitation), "");
}

}  // namespace
}  // namespace rubber_suspension
