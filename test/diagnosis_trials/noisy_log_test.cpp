// Logs whose force is little more than noise, as during holds, do not hide what the other logs show.
#include "diagnosis/checked_diagnosis.h"
#include "diagnosis/rig.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

// Returns a log almost at rest: a force of 4 N with the noise of 20 N of all logs of the rig.
log::Log hold(unsigned seed) {
  log::Log log = runRig("hold " + std::to_string(seed), seed, rigFriction());
  for (std::size_t i = 0; i < log.stamp.size(); ++i) {
    log.displacement[i] = 4e-6 * std::sin(0.002 * static_cast<double>(i));
    log.force[i] = 1e6 * log.displacement[i];
  }
  addNoise(log.force, 20.0, seed);
  return log;
}

TEST(NoisyLog, HidesNothing) {
  const auto result = checkedDiagnosis(rigComponent(), {runRig("one", 1, rigFriction()), hold(5), hold(6)},
                                       {runRig("unseen", 3, rigFriction()), hold(7)});
  EXPECT_EQ(result.answer.verdict, diagnosis::Verdict::named) << result.sentence;
  EXPECT_THAT(result.answer.effects, ElementsAre("friction"));
  // Noise of 20 N is 2 % of the force in the moving log. If the holds had equal weights, the noise floor would be 0.7.
  EXPECT_LT(result.gaps.unseen.noise_floor, 0.1);
  const auto noisy = std::find_if(result.logs.admission.begin(), result.logs.admission.end(),
                                  [](const auto& admission) { return admission.log == "hold 5"; });
  ASSERT_NE(noisy, result.logs.admission.end());
  EXPECT_THAT(noisy->notes, ::testing::Contains(HasSubstr("times the weight of other logs")));
}

}  // namespace
}  // namespace rubber_suspension
