// Simulations with variable steps and trial steps are compared with loops of held forces.
#include "vehicle/simulation.h"

#include "support/test.h"
#include "vehicle/soft_track.h"

namespace rubber_suspension::vehicle {
namespace {

const std::string kConfig = TEST_DIR "/../config/half_bogie.yaml";

Bushes loadedComponents(const std::vector<element::ElementDescription>& further = {}) {
  return loadBushes(Kind::struts, kConfig, further);
}

Scene someTrack() { return softTrack({{2e-3, 7.0, 0.0}, {1e-3, 31.0, 1.0}, {5e-4, 63.0, 2.0}}, 1.2); }

double largestDifference(const Bushes& components, const History& history, const History& reference) {
  const PerBush<double> values = displacementDifference(components, history, reference);
  return *std::max_element(values.begin(), values.end());
}

// Steps that the error control of the integrator rejects have no effect on the forces. Only the linear path between
// accepted steps makes a difference, of second order.
TEST(VehicleSimulation, StepsTakenBackLeaveNoTrace) {
  const Scene scene = someTrack();
  const auto components = loadedComponents({{"friction", {{"maximum_force", {2000.0}}, {"displacement", {1e-3}}}}});
  StepCount coarse_count;
  const History coarse = runVariableStep(scene, components, {1e-9, 1e-3}, &coarse_count);
  const History fine = runVariableStep(scene, components, {1e-9, 0.125e-3});
  EXPECT_GT(coarse_count.taken_back, 10);
  EXPECT_GT(coarse_count.accepted, 1200);
  EXPECT_LT(largestDifference(components, coarse, fine), 2e-3);
}

// The path between accepted steps has an error that is quadratic in the longest step. The exponent is measured from
// three runs, and must be within 0.3 of 2.
TEST(VehicleSimulation, ErrorOfVariableStepsIsOfSecondOrder) {
  const Scene scene = someTrack();
  const auto components = loadedComponents();
  const History exact = runVariableStep(scene, components, {1e-9, 0.0625e-3});
  const auto error = [&](double longest) {
    return largestDifference(components, runVariableStep(scene, components, {1e-9, longest}), exact);
  };
  const double coarse = error(1e-3);
  const double fine = error(0.5e-3);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.3) << coarse << " and " << fine;
}

// A loop with held forces lags by (delay + 1/2) steps. A run without a loop, but with this lag in its components,
// differs from the loop by less than a fiftieth. This limit covers the next order in the step, (w h)^2/24 of the force,
// and the error of the variable steps.
TEST(VehicleSimulation, DelayExplainsTheLoopWithHeldForces) {
  Scene scene = someTrack();
  scene.step = 500000;
  const auto components = loadedComponents();
  const History undelayed = runVariableStep(scene, components, {});
  for (const int delay : {0, 1}) {
    LibraryExchange exchange(components);
    const History loop = runExchange(scene, exchange, delay);
    const auto late = loadedComponents({{"time_delay", {{"delay", {loopDelay(0.5e-3, delay)}}}}});
    const PerBush<double> without = displacementDifference(components, loop, undelayed);
    const PerBush<double> with = displacementDifference(components, loop, runVariableStep(scene, late, {}));
    for (std::size_t i = 0; i < components.size(); ++i) {
      EXPECT_LT(with[i], 0.02 * without[i]) << bushNames(Kind::struts)[i] << ", delay " << delay << ": " << without[i];
    }
  }
}

TEST(VehicleSimulation, AskingForTheForcesOfAStepThatWasNotSentIsRefused) {
  const auto components = loadedComponents();
  LibraryExchange exchange(components);
  const Poses rest(components.size(), Eigen::Isometry3d::Identity());
  exchange.send(0, rest);
  EXPECT_THROW(exchange.receive(1), std::runtime_error);
  EXPECT_THROW(exchange.send(0, rest), std::runtime_error);
}

}  // namespace
}  // namespace rubber_suspension::vehicle
