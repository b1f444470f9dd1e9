// Several effects are named separately although one larger law of the list contains them.
#include "diagnosis/checked_diagnosis.h"
#include "diagnosis/rig.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

double stop(double z) { return 3e6 * (z - std::clamp(z, -0.0013, 0.0013)); }

// A single effect, the coupling of friction and relaxation, fits nearly as well as these two effects.
TEST(WithinALargerLaw, FrictionAndRelaxationBesideAStopAreToldAsThese) {
  // The branch with a stiffness of 8e5 N/m relaxes in 0.15 s.
  const auto branch =
      ofSteps([force = 0.0](double step) mutable { return force = std::exp(-0.004 / 0.15) * force + 8e5 * step; });
  const auto effect = [=, friction = rigFriction()](double time, double z, double rate) mutable {
    return friction(time, z, rate) + branch(time, z, rate) + stop(z);
  };
  const io::ComponentDescription rig = rigComponent();
  estimation::Specification sheet = rig.written();
  sheet.setTolerance({0.01, {}});  // so that other values of the model do not imitate the branch
  const io::ComponentDescription component(rig.name, rig.model(), sheet);
  const diagnosis::Diagnosis result = checkedDiagnosis(component, runRigs({1, 2, 3, 4}, effect, 10.0), {});
  EXPECT_THAT(result.answer.effects, testing::UnorderedElementsAre("friction", "relaxation", "bump_stop"))
      << result.sentence;
}

}  // namespace
}  // namespace rubber_suspension
