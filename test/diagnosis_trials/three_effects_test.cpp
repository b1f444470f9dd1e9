// Three effects at once, of which two look like a single one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "diagnosis/checked_diagnosis.h"
#include "diagnosis/rig.h"

namespace rubber_suspension {
namespace {

constexpr double kLowNoise = 3.0;       // [N]
constexpr double kDisplacement = 2e-3;  // [m] of a hold

// An orifice: its force grows with the square of the rate.
double orifice(double /*time*/, double /*z*/, double rate) { return 4.7e4 * rate * std::abs(rate); }

log::Log withGain(log::Log log, double gain) {
  for (double& force : log.force) {
    force *= gain;
  }
  return log;
}

// Pushed within 1 s and held for 100 s, while the force falls with the logarithm of time.
log::Log hold(const std::string& name, unsigned seed, double displacement, double creep) {
  std::mt19937 generator(seed);
  const auto motion = [&](double time) {
    return time < 1.0 ? std::make_pair(displacement * time, displacement) : std::make_pair(displacement, 0.0);
  };
  const auto effect = [&](double time, double z, double rate) {
    return orifice(time, z, rate) - creep * z * std::log10(1.0 + std::max(0.0, time - 1.0) / 2.0);
  };
  return runMotion(name, generator, motion, effect, kLowNoise, 0.02);
}

// Relaxation has both a dashpot and creep among its laws, and a drift follows what creeps.
TEST(ThreeEffects, AreNamedWhereTwoOfThemLookLikeRelaxation) {
  constexpr double kCreep = 1.5e5;  // [N/m] for each decade
  const std::vector<log::Log> logs = {
      withGain(runRig("one", 1, orifice, kLowNoise), 1.0), withGain(runRig("two", 2, orifice, kLowNoise), 1.2),
      withGain(runRig("three", 3, orifice, kLowNoise), 0.9), hold("hold", 4, kDisplacement, kCreep),
      hold("hold on the other side", 5, -0.7 * kDisplacement, kCreep)};
  const diagnosis::Diagnosis result = checkedDiagnosis(rigComponent(), logs, {});
  EXPECT_THAT(result.effects, ::testing::UnorderedElementsAre("sensor_gain", "viscous_damping", "creep"))
      << result.sentence;
  EXPECT_GT(result.closed, 0.95);
}

}  // namespace
}  // namespace rubber_suspension
