// On logs with holds and a noisy displacement, `replay` of the component file has the gap that the report states.
#include "diagnosis/checked_diagnosis.h"
#include "diagnosis/rig.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/gap/replay.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr double kSensorNoise = 1e-6;  // standard deviation [m]

log::Log withNoise(log::Log log, unsigned seed) {
  addNoise(log.displacement, kSensorNoise, seed);
  return log;
}

log::Log moved(const std::string& name, unsigned seed) {
  return withNoise(runRig(name, seed, rigFriction(), 5.0), seed);
}

// Returns a log that moves from 0 to `first` [m] within 1 s, stays for 8 s, moves to `second` [m] within 1 s, and stays
// for 10 s.
log::Log held(const std::string& name, unsigned seed, double first, double second) {
  const auto motion = [=](double time) {
    const double rate = time < 1.0 ? first : time > 9.0 && time < 10.0 ? second - first : 0.0;
    const double z = time < 1.0    ? first * time
                     : time < 9.0  ? first
                     : time < 10.0 ? first + rate * (time - 9.0)
                                   : second;
    return std::make_pair(z, rate);
  };
  std::mt19937 generator(seed);
  return withNoise(runMotion(name, generator, motion, rigFriction(), 5.0, 0.004), seed);
}

TEST(HeldForce, IsThatOfTheFileThatIsWritten) {
  const diagnosis::Diagnosis found =
      checkedDiagnosis(rigComponent(), {moved("one", 1), moved("two", 2), held("hold", 3, 2e-3, -1.5e-3)},
                       {held("held", 4, 1.6e-3, -1e-3)});
  ASSERT_EQ(found.answer.effects, std::vector<std::string>{"friction"}) << found.sentence;
  const component::Component written = componentOf(io::toYaml({found.law.augmented})).makeComponent();
  // This is the largest gap on further logs that the interval of the closed share permits.
  const double most = found.gaps.unseen.re_estimated -
                      found.gaps.closed_interval[0] * (found.gaps.unseen.re_estimated - found.gaps.unseen.noise_floor);
  for (const log::Log& fresh : {held("fresh", 5, 1.8e-3, -1.2e-3), moved("moved", 6)}) {
    EXPECT_LT(gap::relativeGap(fresh.force, gap::simulateLog(written, fresh)), most) << fresh.name;
  }
}

}  // namespace
}  // namespace rubber_suspension
