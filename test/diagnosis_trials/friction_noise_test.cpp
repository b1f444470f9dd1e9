// A drift beside Berg's friction, whose past nobody knows.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "diagnosis/checked_diagnosis.h"
#include "diagnosis/rig.h"
#include "gap/simulate.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension {
namespace {

// A drift of the load cell beside friction that forgets in the course of a log where it came from.
TEST(FrictionStarts, HideNoDrift) {
  constexpr double kRate = 12.0;  // [N/s], over 20 s of a force of some 1 kN
  const io::ComponentDescription component =
      io::parseComponentFile(
          "components:\n  bush:\n    model: elements\n    elements:\n"
          "      - {type: spring, stiffness: 1.0e6}\n"
          "      - {type: friction, maximum_force: 2000, displacement: 5.0e-3}\n",
          "rig")
          .front();
  std::vector<log::Log> logs;
  for (const unsigned seed : {1U, 2U, 3U}) {
    log::Log log = runRig("log " + std::to_string(seed), seed, [](double, double, double) { return 0.0; });
    const log::Record record = log::makeRecord(log);
    const Eigen::VectorXd force = gap::simulate(component.allElements(), {record}).front();
    std::mt19937 generator(seed);
    std::normal_distribution<double> noise(0.0, 5.0);
    for (Eigen::Index i = 0; i < force.size(); ++i) {
      log.force[static_cast<std::size_t>(i)] = force[i] + kRate * record.dt * static_cast<double>(i) + noise(generator);
    }
    logs.push_back(log);
  }
  const diagnosis::Diagnosis result = checkedDiagnosis(component, logs, {});
  EXPECT_EQ(result.answer.effects, std::vector<std::string>{"force_drift"}) << result.sentence;
}

}  // namespace
}  // namespace rubber_suspension
