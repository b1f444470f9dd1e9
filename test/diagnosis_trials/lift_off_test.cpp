// A strap that goes slack is told, and none is where nothing does.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "diagnosis/rig.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension {
namespace {

/// The rig's component as a strap: while slack, the rate of its length is what relaxes, by Euler steps of a hundredth
/// of a sample.
log::Log strapLog(unsigned seed) {
  constexpr int kParts = 100;
  constexpr double kNoise = 20.0;
  log::Log log = runRig(
      "log " + std::to_string(seed), seed, [](double, double, double) { return 0.0; }, 0.0);
  const auto elements = rigComponent().allElements();
  const double spring = elements[0].value("stiffness");
  const double relaxing = elements[1].value("stiffness");
  const double rate = 2.0 * element::kPi * elements[1].value("break_frequency");
  std::mt19937 generator(seed + 100);
  std::normal_distribution<double> noise(0.0, kNoise);
  double length = std::max(0.0, log.displacement.front());  // of the strap under its force
  double relaxed = length;                                  // what the dashpot has moved
  for (std::size_t i = 0; i < log.size(); ++i) {
    const double from = log.displacement[i == 0 ? 0 : i - 1];
    const double dt = (i == 0 ? 0.0 : log.time(i) - log.time(i - 1)) / kParts;
    for (int part = 1; part <= kParts; ++part) {
      const double plate = from + (log.displacement[i] - from) * part / kParts;
      relaxed += dt * rate * (length - relaxed);
      length = std::max(plate, relaxing * relaxed / (spring + relaxing));
    }
    log.force[i] = spring * length + relaxing * (length - relaxed) + noise(generator);
  }
  return log;
}

TEST(LiftOff, OfAStrapIsTold) {
  const diagnosis::Diagnosis result = diagnosis::diagnose(rigComponent(), {strapLog(1), strapLog(2)}, {});
  ASSERT_THAT(result.effects, testing::ElementsAre("lift_off")) << result.sentence;
  ASSERT_EQ(result.augmented.add.size(), 1U);
  EXPECT_EQ(result.augmented.add.front().type, "lift_off");
  EXPECT_EQ(result.augmented.add.front().value("side"), 1.0);
  EXPECT_LT(result.gap.augmented, 1.2 * result.gap.noise_floor);
}

// A stop of one side makes the forces of the other the smaller ones, as an open contact does.
TEST(LiftOff, IsNotToldOfAStopOfOneSide) {
  std::vector<log::Log> logs;
  for (unsigned seed = 1; seed <= 2; ++seed) {
    logs.push_back(runRig("log " + std::to_string(seed), seed,
                          [](double, double z, double) { return 3e6 * std::max(0.0, z - 5e-4); }));
  }
  const diagnosis::Diagnosis result = diagnosis::diagnose(rigComponent(), logs, {});
  EXPECT_THAT(result.effects, testing::Not(testing::Contains("lift_off"))) << result.sentence;
}

}  // namespace
}  // namespace rubber_suspension
