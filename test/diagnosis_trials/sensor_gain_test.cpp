// A wrong gain of the force channel is reported beside the equivalent wrong values. It is not reported for unequal
// errors of the values, or within the rig's tolerance.
#include "diagnosis/checked_diagnosis.h"
#include "diagnosis/rig.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

log::Log runWithGain(const std::string& name, unsigned seed, double gain, const RigEffect& effect = nothing) {
  log::Log log = runRig(name, seed, effect);
  for (double& force : log.force) {
    force *= 1.0 + gain;
  }
  return log;
}

diagnosis::Diagnosis diagnoseWithGain(double gain, const io::ComponentDescription& component = rigComponent()) {
  return checkedDiagnosis(component, {runWithGain("one", 1, gain), runWithGain("two", 2, gain)},
                          {runWithGain("unseen", 3, gain)});
}

// Only its tolerance distinguishes a gain from values that are all off by the same factor. Both are reported, and the
// sentence itself states the gain if it is far more likely. The size of the gain is correct.
TEST(SensorGain, IsToldBesideWrongValues) {
  for (const double gain : {0.5, -0.4, 0.06, -0.12}) {
    const diagnosis::Diagnosis result = diagnoseWithGain(gain);
    const std::vector<std::string> named = {"sensor_gain"};
    const bool is_named = result.answer.effects == named;
    EXPECT_TRUE(is_named || result.answer.verdict == diagnosis::Verdict::parameter_error) << result.sentence;
    const bool is_alternative = std::any_of(result.answer.alternatives.begin(), result.answer.alternatives.end(),
                                            [&](const auto& other) { return other.effects == named; });
    EXPECT_TRUE(is_alternative ||
                result.sentence.find("or all stiffness and damping values of the model are wrong by this share") !=
                    std::string::npos)
        << result.sentence;
    const auto found = std::find_if(result.candidates.begin(), result.candidates.end(),
                                    [](const auto& candidate) { return candidate.effect == "sensor_gain"; });
    ASSERT_NE(found, result.candidates.end());
    // The tolerance covers noise of 20 N on some 5000 samples of 1 kN. The prior of the values has less influence.
    EXPECT_NEAR(found->parameters.at("gain"), gain, 0.005);
  }
}

TEST(SensorGain, IsNoneOfAnUnevenError) {
  io::ComponentDescription wrong = rigComponent();
  estimation::Specification specification = wrong.specification();
  specification.set("static_stiffness", 0.85e6);
  wrong.specify(specification);
  EXPECT_EQ(diagnoseWithGain(0.0, wrong).answer.verdict, diagnosis::Verdict::parameter_error);
}

TEST(SensorGain, WithinTheToleranceIsNoCause) {
  io::ComponentDescription component = rigComponent();
  component.rig = io::RigTolerances{};
  component.rig->gain = {0.25, true};  // standard deviation of the logarithm of the gain; ln 1.2 is smaller
  const diagnosis::Diagnosis result = diagnoseWithGain(0.2, component);
  EXPECT_TRUE(result.answer.effects.empty()) << result.sentence;
}

double gainFound(const diagnosis::Diagnosis& result, const std::string& log) {
  const auto found = std::find_if(result.rig_findings.begin(), result.rig_findings.end(), [&](const auto& finding) {
    return finding.log == log && finding.finding == "sensor_gain";
  });
  return found == result.rig_findings.end() ? 0.0 : found->value;
}

// If the range of an amplifier changed between logs, this is a finding about each log, not an effect.
TEST(SensorGain, BelongsToTheLogsWhereItDiffers) {
  const diagnosis::Diagnosis result =
      checkedDiagnosis(rigComponent(), {runWithGain("one", 1, 0.1), runWithGain("two", 2, -0.05)},
                       {runWithGain("unseen", 3, 0.1), runWithGain("other", 4, -0.05)});
  EXPECT_EQ(result.answer.verdict, diagnosis::Verdict::none) << result.sentence;
  EXPECT_TRUE(result.law.augmented.add.empty());
  EXPECT_LT(result.gaps.unseen.augmented, 1.05 * result.gaps.unseen.noise_floor);
  EXPECT_NEAR((1.0 + gainFound(result, "one")) / (1.0 + gainFound(result, "two")), 1.1 / 0.95, 0.005);
  EXPECT_NEAR((1.0 + gainFound(result, "unseen")) / (1.0 + gainFound(result, "other")), 1.1 / 0.95, 0.005);
}

TEST(SensorGain, MayStandBesideAnotherEffect) {
  const auto run = [](const std::string& name, unsigned seed, double gain) {
    return runWithGain(name, seed, gain, rigFriction());
  };
  const diagnosis::Diagnosis result = checkedDiagnosis(
      rigComponent(), {run("one", 1, 0.15), run("two", 2, -0.15), run("three", 5, 0.15)}, {run("unseen", 3, -0.15)});
  EXPECT_THAT(result.answer.effects, ElementsAre("friction")) << result.sentence;
  EXPECT_NEAR((1.0 + gainFound(result, "one")) / (1.0 + gainFound(result, "two")), 1.15 / 0.85, 0.01);
}

// Gains of single logs can imitate an effect that depends on amplitude. Here the stiffness of the largest log is a
// fifth higher than that of the smallest.
TEST(SensorGain, IsNoneOfAnEffectThatDependsOnAmplitude) {
  const auto run = [](const std::string& name, unsigned seed, double share) {
    log::Log log = runRig(name, seed, nothing);
    for (std::size_t i = 0; i < log.stamp.size(); ++i) {
      log.displacement[i] *= share;
      log.force[i] = share * log.force[i] + 6e10 * std::pow(log.displacement[i], 3);
    }
    return log;
  };
  const diagnosis::Diagnosis result = checkedDiagnosis(
      rigComponent(), {run("small", 1, 0.5), run("middle", 2, 0.75), run("large", 5, 1.0)}, {run("unseen", 3, 0.9)});
  EXPECT_THAT(result.answer.effects, ElementsAre("progressive_stiffness")) << result.sentence;
}

}  // namespace
}  // namespace rubber_suspension
