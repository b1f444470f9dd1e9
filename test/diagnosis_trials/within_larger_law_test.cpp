// Effects that a law of the list contains together.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "diagnosis/checked_diagnosis.h"
#include "diagnosis/rig.h"

namespace rubber_suspension {
namespace {

// A branch that forgets within half a second.
RigEffect relaxing() {
  return [force = 0.0, last = 0.0, before = 0.0](double time, double z, double /*rate*/) mutable {
    constexpr double kStiffness = 8e5;  // [N/m]
    constexpr double kTime = 0.15;      // [s]
    const double decay = std::exp(-(time - before) / kTime);
    force = time == 0.0 ? 0.0 : decay * force + kStiffness * (z - last);
    last = z;
    before = time;
    return force;
  };
}

double stop(double z) { return 3e6 * (z - std::clamp(z, -0.0013, 0.0013)); }

// A coupling of friction and relaxation does nearly the same as both, with fewer names.
TEST(WithinALargerLaw, FrictionAndRelaxationBesideAStopAreToldAsThese) {
  std::vector<log::Log> logs;
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    const auto effect = [friction = rigFriction(), branch = relaxing()](double time, double z, double rate) {
      return friction(time, z, rate) + branch(time, z, rate) + stop(z);
    };
    logs.push_back(runRig("log " + std::to_string(seed), seed, effect, 10.0));
  }
  const io::ComponentDescription rig = rigComponent();
  estimation::Specification sheet = rig.written();
  sheet.setTolerance({0.01, {}});  // so that the branch is no other value of it
  const io::ComponentDescription component(rig.name, rig.model(), sheet);
  const diagnosis::Diagnosis result = checkedDiagnosis(component, logs, {});
  EXPECT_THAT(result.answer.effects, testing::UnorderedElementsAre("friction", "relaxation", "bump_stop"))
      << result.sentence;
}

}  // namespace
}  // namespace rubber_suspension
