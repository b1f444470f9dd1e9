// What a motion before a log leaves in Berg's friction.
#include "diagnosis/friction_noise.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "checked_diagnosis.h"
#include "gap/simulate.h"
#include "rig.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension {
namespace {

constexpr double kMaximumForce = 2e3;

std::vector<element::ElementDescription> elementsWithBerg(double displacement) {
  auto elements = rigComponent().allElements();
  elements.push_back({"friction", {{"maximum_force", {kMaximumForce}}, {"displacement", {displacement}}}});
  return elements;
}

std::vector<log::Record> records() {
  return {log::makeRecord(runRig("one", 1, [](double, double, double) { return 0.0; }))};
}

double deviation(const Eigen::VectorXd& values) { return std::sqrt((values.array() - values.mean()).square().mean()); }

// Root mean square of what such friction forgets in the course of the log, over its force.
double forgotten(double displacement) {
  const Eigen::MatrixXd starts = diagnosis::frictionStarts(elementsWithBerg(displacement), records())[0];
  return std::max(deviation(starts.col(0)), deviation(starts.col(1))) / kMaximumForce;
}

TEST(FrictionStarts, AreNoneWithoutBergsFriction) {
  EXPECT_EQ(diagnosis::frictionStarts(rigComponent().allElements(), records())[0].cols(), 0);
}

TEST(FrictionStarts, AreNoneWhereThePastIsKnown) {
  auto logs = records();
  logs[0].lead_in = Eigen::Vector3d::Zero();
  EXPECT_EQ(diagnosis::frictionStarts(elementsWithBerg(5e-3), logs)[0].cols(), 0);
}

// Motion of up to 2 mm slides such friction to and fro: from the first turns on, nothing tells where it came from.
TEST(FrictionStarts, AreNextToNoneWhereMotionSlides) { EXPECT_LT(forgotten(1e-5), 0.06); }

// Friction that 2 mm hardly move, 200 mm to half its force, is a spring: what it carries from before is a zero.
TEST(FrictionStarts, AreAZeroWhereFrictionHardlyMoves) { EXPECT_LT(forgotten(0.2), 1e-3); }

// In between it forgets in the course of the log.
TEST(FrictionStarts, AreLargestInBetween) { EXPECT_GT(forgotten(5e-3), forgotten(0.2)); }

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
  EXPECT_EQ(result.effects, std::vector<std::string>{"force_drift"}) << result.sentence;
}

}  // namespace
}  // namespace rubber_suspension
