// A strap that goes slack is named, with its force. No strap is named on rigs without one.
#include "diagnosis/rig.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr double kNoise = 20.0;  // [N]

/// Replaces the force by the force of a strap (side 1) or of a chevron (side -1). While slack, its length follows the
/// relaxation, in Euler steps of a hundredth of a sample.
log::Log unglued(log::Log log, double side) {
  constexpr int kPartsOfSample = 100;
  const auto elements = rigComponent().allElements();
  const double spring = elements[0].value("stiffness");
  const double relaxing = elements[1].value("stiffness");
  const double rate = 2.0 * element::kPi * elements[1].value("break_frequency");
  double length = std::max(0.0, side * log.displacement.front());  // length of the strap under force
  double relaxed = length;                                         // displacement of the dashpot
  for (std::size_t i = 0; i < log.size(); ++i) {
    const double from = log.displacement[i == 0 ? 0 : i - 1];
    const double dt = (i == 0 ? 0.0 : log.time(i) - log.time(i - 1)) / kPartsOfSample;
    for (int part = 1; part <= kPartsOfSample; ++part) {
      const double plate = side * (from + (log.displacement[i] - from) * part / kPartsOfSample);
      relaxed += dt * rate * (length - relaxed);
      length = std::max(plate, relaxing * relaxed / (spring + relaxing));
    }
    log.force[i] = side * (spring * length + relaxing * (length - relaxed));
  }
  addNoise(log.force, kNoise, static_cast<unsigned>(log.size()));
  return log;
}

/// Replaces the force as `unglued` does, and measures displacement and force from a preloaded state.
log::Log preloaded(log::Log log, double side, double preload) {
  const double zero = side * preload / rigComponent().allElements()[0].value("stiffness");
  const std::vector<double> displacement = log.displacement;
  for (double& z : log.displacement) {
    z += zero;
  }
  log = unglued(std::move(log), side);
  log.displacement = displacement;
  for (double& force : log.force) {
    force -= side * preload;
  }
  return log;
}

/// Records ramps to 2 mm on one side and back, one log for each of three rates.
std::vector<log::Log> rampLogs(double side, const RigEffect& effect) {
  constexpr double kReach = 2e-3;
  std::vector<log::Log> logs;
  for (const double speed : {2e-2, 5e-3, 1e-3}) {
    std::mt19937 generator(static_cast<unsigned>(logs.size()));
    const auto motion = [&](double time) {
      const double period = 2.0 * kReach / speed;
      const double phase = time / period - std::floor(time / period);
      const double up = phase < 0.5 ? 1.0 : -1.0;
      return std::make_pair(side * kReach * (1.0 - std::abs(1.0 - 2.0 * phase)), side * up * speed);
    };
    logs.push_back(runMotion("ramps " + std::to_string(logs.size()), generator, motion, effect, kNoise, 0.004));
  }
  return logs;
}

TEST(LiftOff, OfAStrapIsTold) {
  const std::vector<log::Log> logs = {unglued(runRig("one", 1, nothing), 1.0), unglued(runRig("two", 2, nothing), 1.0)};
  const diagnosis::Diagnosis result = diagnosis::diagnose(rigComponent(), logs, {});
  ASSERT_THAT(result.answer.effects, testing::ElementsAre("lift_off")) << result.sentence;
  ASSERT_EQ(result.law.augmented.add.size(), 1U);
  EXPECT_EQ(result.law.augmented.add.front().type, "lift_off");
  EXPECT_EQ(result.law.augmented.add.front().value("side"), 1.0);
  EXPECT_LT(result.gaps.unseen.augmented, 1.2 * result.gaps.unseen.noise_floor);
}

TEST(LiftOff, BeyondAPreloadIsToldWithIt) {
  constexpr double kPreload = 800.0;
  std::vector<log::Log> logs;
  for (const unsigned seed : {1U, 2U}) {
    logs.push_back(preloaded(runRig("log " + std::to_string(seed), seed, nothing), -1.0, kPreload));
  }
  const diagnosis::Diagnosis result = diagnosis::diagnose(rigComponent(), logs, {});
  ASSERT_THAT(result.answer.effects, testing::ElementsAre("lift_off")) << result.sentence;
  ASSERT_EQ(result.law.augmented.add.size(), 1U);
  // An offset of the displacement, which the fit allows in each log, resembles a preload on a linear test piece.
  EXPECT_NEAR(result.law.augmented.add.front().value("preload"), kPreload, 0.06 * kPreload);
  EXPECT_THAT(result.sentence, testing::HasSubstr("opens in tension beyond its preload, preload "));
  EXPECT_LT(result.gaps.unseen.augmented, 1.2 * result.gaps.unseen.noise_floor) << result.sentence;
}

TEST(LiftOff, OnRampsIsToldWithTheSideThatItCarries) {
  for (const auto& [side, carries] : {std::pair(1.0, "tension"), std::pair(-1.0, "compression")}) {
    std::vector<log::Log> logs = rampLogs(side, nothing);
    for (log::Log& log : logs) {
      log = unglued(std::move(log), side);
    }
    const diagnosis::Diagnosis result = diagnosis::diagnose(rigComponent(), logs, {});
    EXPECT_THAT(result.answer.effects, testing::ElementsAre("lift_off")) << result.sentence;
    EXPECT_THAT(result.sentence, testing::HasSubstr(std::string("carries ") + carries + " alone"));
    EXPECT_LT(result.gaps.unseen.augmented, 1.2 * result.gaps.unseen.noise_floor) << result.sentence;
  }
}

// On these ramps the force has mostly one sign, as under lift-off.
TEST(LiftOff, IsNotToldOfFriction) {
  const diagnosis::Diagnosis result = diagnosis::diagnose(rigComponent(), rampLogs(1.0, rigFriction()), {});
  EXPECT_THAT(result.answer.effects, testing::Contains("friction")) << result.sentence;
  EXPECT_THAT(result.answer.effects, testing::Not(testing::Contains("lift_off"))) << result.sentence;
}

// A stop on one side leaves smaller forces on the other side, as an open contact does.
TEST(LiftOff, IsNotToldOfAStopOfOneSide) {
  const auto stop = [](double, double z, double) { return 3e6 * std::max(0.0, z - 5e-4); };
  const diagnosis::Diagnosis result = diagnosis::diagnose(rigComponent(), runRigs({1, 2}, stop), {});
  EXPECT_THAT(result.answer.effects, testing::Not(testing::Contains("lift_off"))) << result.sentence;
}

}  // namespace
}  // namespace rubber_suspension
