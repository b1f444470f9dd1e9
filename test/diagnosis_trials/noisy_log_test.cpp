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

// Returns a log of a component without effects, with 1/f noise of 150 N, or 12 % of the force: a sum of first-order
// processes whose time constants lie an octave apart (van der Ziel, Physica 16, 1950).
log::Log withColouredNoise(const std::string& name, unsigned seed) {
  log::Log log = runRig(name, seed, nothing);
  std::mt19937 generator(seed);
  constexpr double kProcesses = 8.0;  // from 2 to 256 samples, or 0.2 to 20 Hz
  std::normal_distribution<double> normal(0.0, 150.0 / std::sqrt(kProcesses));
  for (int octave = 1; octave <= static_cast<int>(kProcesses); ++octave) {
    const double pole = std::exp(-std::exp2(-octave));
    double state = normal(generator);
    for (double& force : log.force) {
      state = pole * state + std::sqrt(1.0 - pole * pole) * normal(generator);
      force += state;
    }
  }
  return log;
}

// The power of the noise does not follow the motion, so no effect is needed to explain the residual.
TEST(NoisyLog, OfColouredNoiseLacksNoEffect) {
  const auto result = checkedDiagnosis(
      rigComponent(), {withColouredNoise("a", 1), withColouredNoise("b", 2), withColouredNoise("c", 3)}, {});
  EXPECT_THAT(result.answer.effects, ::testing::IsEmpty()) << result.sentence;
  EXPECT_NE(result.answer.verdict, diagnosis::Verdict::unknown) << result.sentence;
  const auto found = std::count_if(result.rig_findings.begin(), result.rig_findings.end(), [](const auto& finding) {
    return finding.finding == measurement::finding::kColouredNoise;
  });
  EXPECT_EQ(found, 3);
}

// A residual that follows the motion is no noise, although the verdict on it is open.
TEST(NoisyLog, OfAnUnlistedLawHasNoColouredNoise) {
  const RigEffect growing = [](double time, double z, double /*rate*/) { return 2e5 * z * std::sin(3.0 * time); };
  const auto result = checkedDiagnosis(rigComponent(), {runRig("a", 1, growing), runRig("b", 2, growing)}, {});
  for (const auto& finding : result.rig_findings) {
    EXPECT_NE(finding.finding, measurement::finding::kColouredNoise) << result.sentence;
  }
}

}  // namespace
}  // namespace rubber_suspension
