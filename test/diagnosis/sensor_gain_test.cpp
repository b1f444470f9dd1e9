// A force channel of wrong gain: told beside wrong values, which do the same; not where values are off by other
// factors, and not within the rig's tolerance.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "checked_diagnosis.h"
#include "rig.h"

namespace rubber_suspension {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

log::Log runWithGain(const std::string& name, unsigned seed, double gain) {
  log::Log log = runRig(name, seed, [](double, double, double) { return 0.0; });
  for (double& force : log.force) {
    force *= 1.0 + gain;
  }
  return log;
}

diagnosis::Diagnosis diagnoseWithGain(double gain, const io::ComponentDescription& component = rigComponent()) {
  return checkedDiagnosis(component, {runWithGain("one", 1, gain), runWithGain("two", 2, gain)},
                          {runWithGain("unseen", 3, gain)});
}

TEST(SensorGain, IsToldBesideWrongValues) {
  for (const double gain : {0.5, -0.4}) {
    const diagnosis::Diagnosis result = diagnoseWithGain(gain);
    EXPECT_EQ(result.verdict, "confounded") << result.sentence;
    EXPECT_THAT(result.effects, ElementsAre("sensor_gain"));
    ASSERT_EQ(result.confounded.size(), 1U);
    EXPECT_THAT(result.confounded[0], ElementsAre("sensor_gain", "parameter_error"));
    const auto found = std::find_if(result.candidates.begin(), result.candidates.end(),
                                    [](const auto& candidate) { return candidate.effect == "sensor_gain"; });
    ASSERT_NE(found, result.candidates.end());
    // 20 N of noise on some 5000 samples of a kN; what the prior on the values leaves to them is less.
    EXPECT_NEAR(found->parameters.at("gain"), gain, 0.005);
    EXPECT_THAT(result.sentence, HasSubstr(gain > 0.0 ? "50.0 % too much" : "too little"));
    EXPECT_THAT(result.next_experiment, HasSubstr("known weight"));
  }
}

// Specifications err by as much.
TEST(SensorGain, IsLessLikelyThanWrongValuesThatSpecificationsHave) {
  for (const double gain : {0.08, -0.12}) {
    const diagnosis::Diagnosis result = diagnoseWithGain(gain);
    EXPECT_EQ(result.verdict, "parameter_error") << result.sentence;
    EXPECT_THAT(result.sentence,
                HasSubstr(gain > 0.0 ? "So would a force channel that reads 8.0 % too much" : "too little"));
  }
}

TEST(SensorGain, IsNoneOfAnUnevenError) {
  io::ComponentDescription wrong = rigComponent();
  estimation::Specification specification = wrong.specification();
  specification.set("static_stiffness", 0.85e6);
  wrong.specify(specification);
  EXPECT_EQ(diagnoseWithGain(0.0, wrong).verdict, "parameter_error");
}

TEST(SensorGain, WithinTheToleranceIsNoCause) {
  io::ComponentDescription component = rigComponent();
  component.rig = io::RigTolerances{};
  component.rig->gain = {0.25, true};  // 2 standard deviations of it are more than ln 1.5
  const diagnosis::Diagnosis result = diagnoseWithGain(0.5, component);
  EXPECT_TRUE(result.effects.empty()) << result.sentence;
}

}  // namespace
}  // namespace rubber_suspension
