// An effect is found beside a force that does not depend on the motion.
#include "diagnosis/checked_diagnosis.h"
#include "diagnosis/rig.h"
#include "rubber_suspension/element/constants.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr double kRigNoise = 10.0;  // [N]
constexpr double kHum = 250.0;      // amplitude [N]; the force is about 1 kN

// Another machine with varying speed shakes the rig within the band of the motion, with a new phase in each log.
RigEffect machineNextDoor(double phase) {
  return [phase](double time, double /*displacement*/, double /*rate*/) {
    const double turns = 4.3 * time + 0.6 * std::sin(0.9 * time + phase);
    return kHum * std::sin(2.0 * element::kPi * turns + 3.0 * phase);
  };
}

TEST(BesideHum, NothingIsNamedWhereTheMotionCausesNothing) {
  std::vector<log::Log> logs;
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    logs.push_back(runRig("log " + std::to_string(seed), seed, machineNextDoor(seed), kRigNoise));
  }
  const diagnosis::Diagnosis result = checkedDiagnosis(rigComponent(), logs, {});
  ASSERT_EQ(result.answer.verdict, diagnosis::Verdict::unknown) << result.sentence;
  // The surrogate contains the elements of the augmented component and one more.
  ASSERT_TRUE(result.surrogate);
  const auto below = result.law.augmented.allElements();
  const auto elements = result.surrogate->component.allElements();
  ASSERT_EQ(elements.size(), below.size() + 1);
  for (std::size_t i = 0; i < below.size(); ++i) {
    EXPECT_EQ(elements[i].values, below[i].values) << below[i].type;
  }
}

}  // namespace
}  // namespace rubber_suspension
