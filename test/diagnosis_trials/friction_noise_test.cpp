// A drift is found beside Berg's friction with an unknown initial state.
#include "diagnosis/checked_diagnosis.h"
#include "diagnosis/rig.h"
#include "gap/simulate.h"
#include "rubber_suspension/log/record.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

// The force sensor drifts while friction slowly forgets its initial state.
TEST(FrictionStarts, HideNoDrift) {
  constexpr double kRate = 12.0;  // [N/s], for 20 s; the force is about 1 kN
  const io::ComponentDescription component("bush", {spring(1e6), friction(2e3, 5e-3)});
  std::vector<log::Log> logs = runRigs({1, 2, 3}, nothing);
  for (unsigned log = 0; log < logs.size(); ++log) {
    const log::Record record = log::makeRecord(logs[log]);
    const Eigen::VectorXd force = gap::simulate(component.allElements(), {record}).front();
    for (Eigen::Index i = 0; i < force.size(); ++i) {
      logs[log].force[static_cast<std::size_t>(i)] = force[i] + kRate * record.dt * static_cast<double>(i);
    }
    addNoise(logs[log].force, 5.0, log + 1);
  }
  const diagnosis::Diagnosis result = checkedDiagnosis(component, logs, {});
  EXPECT_EQ(result.answer.effects, std::vector<std::string>{"force_drift"}) << result.sentence;
}

}  // namespace
}  // namespace rubber_suspension
