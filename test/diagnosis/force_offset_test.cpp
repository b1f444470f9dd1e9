// An offset of the force that differs between logs is found beside friction, and is not mistaken for a drift.
#include "diagnosis/checked_diagnosis.h"
#include "diagnosis/rig.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

RigEffect beside(RigEffect effect, double offset) {
  return [effect = std::move(effect), offset](double time, double z, double rate) {
    return offset + effect(time, z, rate);
  };
}

double zeroFound(const diagnosis::Diagnosis& result, const std::string& log) {
  const auto found = std::find_if(result.rig_findings.begin(), result.rig_findings.end(), [&](const auto& finding) {
    return finding.log == log && finding.finding == "force_zero";
  });
  return found == result.rig_findings.end() ? 0.0 : found->value;
}

// A pneumatic seal adds a force of pressure times area: tens of standard deviations, and different in each log.
TEST(ForceOffset, OfEachLogStandsBesideFriction) {
  const diagnosis::Diagnosis result = checkedDiagnosis(
      rigComponent(),
      {runRig("1 bar", 1, beside(rigFriction(), 8e3)), runRig("3 bar", 2, beside(rigFriction(), 22e3)),
       runRig("7 bar", 3, beside(rigFriction(), 50e3))},
      {runRig("5 bar", 4, beside(rigFriction(), 36e3)), runRig("2 bar", 5, beside(rigFriction(), 15e3))});
  EXPECT_THAT(result.answer.effects, ElementsAre("friction")) << result.sentence;
  EXPECT_LT(result.gaps.unseen.augmented, 1.3 * result.gaps.unseen.noise_floor);
  // The tolerance covers the noise of 20 N and the correlation of offset and friction in the fit.
  EXPECT_NEAR(zeroFound(result, "7 bar") - zeroFound(result, "1 bar"), 42e3, 60.0);
  EXPECT_NEAR(zeroFound(result, "5 bar") - zeroFound(result, "2 bar"), 21e3, 60.0);
}

// An offset that all logs share is the same effect with one parameter.
TEST(ForceOffset, OfAllLogsIsOneNumber) {
  const RigEffect zero = [](double, double, double) { return 900.0; };
  const diagnosis::Diagnosis result = checkedDiagnosis(rigComponent(), runRigs({1, 2}, zero), runRigs({3}, zero));
  EXPECT_THAT(result.answer.effects, ElementsAre("force_offset")) << result.sentence;
  ASSERT_EQ(result.law.augmented.add.size(), 1U);
  EXPECT_NEAR(result.law.augmented.add.front().value("offset"), 900.0, 20.0);
}

// The residual of triangles of 6 s in a log of a minute repeats with each period, so it is not a drift.
TEST(ForceOffset, TrianglesAreNoDrift) {
  const auto triangles = [](const std::string& name, unsigned seed, double amplitude) {
    std::mt19937 generator(seed);
    constexpr double kStep = 0.012;
    constexpr double kPeriod = 6.0;
    const auto motion = [&](double time) {
      const double phase = std::fmod(time / kPeriod, 1.0);
      const double z = phase < 0.25 ? 4.0 * phase : phase < 0.75 ? 2.0 - 4.0 * phase : 4.0 * phase - 4.0;
      const double rate = (phase < 0.25 || phase >= 0.75 ? 4.0 : -4.0) / kPeriod;
      return std::make_pair(amplitude * z, amplitude * rate);
    };
    return runMotion(name, generator, motion, rigFriction(), 20.0, kStep);
  };
  const diagnosis::Diagnosis result = checkedDiagnosis(
      rigComponent(), {triangles("small", 1, 0.5e-3), triangles("large", 2, 2e-3)}, {triangles("unseen", 3, 1e-3)});
  EXPECT_THAT(result.answer.effects, Not(Contains("force_drift"))) << result.sentence;
  EXPECT_THAT(result.answer.effects, Contains("friction")) << result.sentence;
}

}  // namespace
}  // namespace rubber_suspension
