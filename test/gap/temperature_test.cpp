// The temperature in the simulation of a log: per sample, without a column, and out of the range of the shift.
#include "gap/simulate.h"
#include "rubber_suspension/gap/replay.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

const Entries kElements = {spring(3e6), maxwell(1.2e6, 2.0),
                           entry("wlf_shift c1=6.13 c2=146.8 reference=20 vertical=0.003")};

const Entries kUnshifted(kElements.begin(), kElements.begin() + 2);

// Returns more samples than `replay` processes at a time.
log::Log warmingLog() {
  log::Log log = logOf(
      "warming", 6000, 2000000, [](int i) { return 1e-3 * std::sin(0.05 * i) + 2e-4 * std::sin(0.4 * i); },
      [](int /*i*/, double z) { return 3e6 * z; });
  for (int i = 0; i < 6000; ++i) {
    log.temperature.push_back(10.0 + 0.01 * (i / 10));
  }
  return log;
}

TEST(ReplayWithTemperature, EachSampleHasItsOwn) {
  const component::Component component(kElements);
  const log::Log log = warmingLog();
  const std::vector<double> forces = gap::simulateLog(component, log);
  component::SampleStream stream(component);
  for (std::size_t i = 0; i < log.size(); ++i) {
    ASSERT_TRUE(stream.setTemperature(log.temperature[i]));
    ASSERT_EQ(forces[i], stream.push(log.stamp[i], log.displacement[i]).force.total) << i;
  }
}

TEST(ReplayWithTemperature, WithoutTheColumnOrTheKeyNothingChanges) {
  log::Log without = warmingLog();
  without.temperature.clear();
  const std::vector<double> plain = gap::simulateLog(component::Component(kUnshifted), without);
  EXPECT_EQ(gap::simulateLog(component::Component(kElements), without), plain);
  EXPECT_EQ(gap::simulateLog(component::Component(kUnshifted), warmingLog()), plain);
}

TEST(ReplayWithTemperature, RefusesWhereTheShiftDoesNotHold) {
  log::Log cold = warmingLog();
  cold.temperature[4321] = -120.0;
  const component::Component component(kElements);
  for (const auto& refuse : {std::function<void()>([&] { gap::simulateLog(component, cold); }),
                             std::function<void()>([&] { gap::checkTemperature(component, cold); })}) {
    const std::string message = messageOf<log::LogError>([&] { refuse(); });
    EXPECT_THAT(message, HasSubstr("warming: sample 4322: temperature -120 degC is out of range; accepted: at "
                                   "least -92.36"));  // 20 - 146.8 20/26.13
  }
}

// The diagnosis computes the forces of `replay`, up to the rounding of the time step.
TEST(ReplayWithTemperature, RecordsFollowItToo) {
  const log::Log log = warmingLog();
  const std::vector<double> replayed = gap::simulateLog(component::Component(kElements), log);
  const gap::Forces forces = gap::simulateEach(kElements, {log::makeRecord(log)});
  for (std::size_t i = 0; i < log.size(); ++i) {
    ASSERT_NEAR(forces[0][static_cast<Eigen::Index>(i)], replayed[i], 1e-9 * 3e3) << i;
  }
  log::Log without = log;
  without.temperature.clear();
  const gap::Forces both = gap::simulate(kElements, {log::makeRecord(log), log::makeRecord(without)});
  const gap::Forces plain = gap::simulate(kUnshifted, {log::makeRecord(without), log::makeRecord(without)});
  EXPECT_EQ(both[1], plain[1]) << "a record without a temperature is at the reference";
}

// Motion before the log, which may explain a force of the rig, is simulated at the first temperature of the log.
TEST(ReplayWithTemperature, AMotionBeforeTheLogHasItsFirstTemperature) {
  log::Record record = log::makeRecord(warmingLog());
  log::Record longer = record;
  constexpr Eigen::Index kBefore = 50;
  longer.displacement = Eigen::VectorXd::Constant(record.size() + kBefore, record.displacement[0]);
  longer.displacement.tail(record.size()) = record.displacement;
  const Eigen::VectorXd force = gap::simulate(kElements, {record}).front();
  // The component rests before the log, so the forces are equal up to the rounding in additional steps.
  EXPECT_LE((gap::simulate(kElements, {longer}).front().tail(record.size()) - force).cwiseAbs().maxCoeff(), 1e-9 * 3e3);
}

}  // namespace
}  // namespace rubber_suspension
