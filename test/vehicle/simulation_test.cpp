// The three ways to step against each other: variable steps with trials, implicit, and loops with held forces.
#include "vehicle/simulation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rubber_suspension/element/constants.h"
#include "support/message_of.h"
#include "vehicle/components.h"
#include "vehicle/soft_track.h"
#include "vehicle/stability.h"

namespace rubber_suspension::vehicle {
namespace {

const std::string kConfig = TEST_DIR "/../config/half_bogie.yaml";

std::vector<component::Component> loadedComponents(const std::vector<element::ElementDescription>& further = {}) {
  return loadStruts(kConfig, further);
}

Scene someTrack() { return softTrack({{2e-3, 7.0, 0.0}, {1e-3, 31.0, 1.0}, {5e-4, 63.0, 2.0}}, 1.2); }

double largest(const PerStrut& values) { return std::max({values[0], values[1], values[2]}); }

// A bogie whose steps are taken back, since their length is left to the integrator's error, has the forces of one that
// steps evenly. What differs is the linear path between accepted steps, of second order.
TEST(VehicleSimulation, StepsTakenBackLeaveNoTrace) {
  const Scene scene = someTrack();
  const auto components = loadedComponents({{"friction", {{"maximum_force", {2000.0}}, {"displacement", {1e-3}}}}});
  StepCount coarse_count;
  const History coarse = runVariableStep(scene, components, {1e-9, 1e-3}, &coarse_count);
  const History fine = runVariableStep(scene, components, {1e-9, 0.125e-3});
  EXPECT_GT(coarse_count.taken_back, 10);
  EXPECT_GT(coarse_count.accepted, 1200);
  EXPECT_LT(largest(displacementDifference(coarse, fine)), 2e-3);
}

// Errors of the path between accepted steps fall with its square: half the longest step, a quarter of the error. The
// exponent is measured between three runs, and lies within 0.3 of 2.
TEST(VehicleSimulation, ErrorOfVariableStepsIsOfSecondOrder) {
  const Scene scene = someTrack();
  const auto components = loadedComponents();
  const History exact = runVariableStep(scene, components, {1e-9, 0.0625e-3});
  const double coarse = largest(displacementDifference(runVariableStep(scene, components, {1e-9, 1e-3}), exact));
  const double fine = largest(displacementDifference(runVariableStep(scene, components, {1e-9, 0.5e-3}), exact));
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.3) << coarse << " and " << fine;
}

// Newmark's method is of second order, too.
TEST(VehicleSimulation, ImplicitStepsConvergeToTheSameForces) {
  Scene scene = someTrack();
  const auto components = loadedComponents();
  const auto difference = [&](std::int64_t step, int* iterations) {
    scene.step = step;
    return largest(displacementDifference(runImplicit(scene, components, iterations),
                                          runVariableStep(scene, components, {1e-9, 0.1e-3})));
  };
  int iterations = 0;
  const double coarse = difference(2000000, &iterations);
  EXPECT_LE(iterations, 4 * scene.steps());  // Newton's method with the right tangent
  const double fine = difference(1000000, nullptr);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.3) << coarse << " and " << fine;
}

// With a friction element, too, whose tangent changes at each reversal.
TEST(VehicleSimulation, ImplicitStepsTakeFriction) {
  const Scene scene = someTrack();
  const auto components = loadedComponents({{"friction", {{"maximum_force", {2000.0}}, {"displacement", {1e-3}}}}});
  const PerStrut difference =
      displacementDifference(runImplicit(scene, components), runVariableStep(scene, components, {1e-9, 0.1e-3}));
  EXPECT_LT(largest(difference), 5e-3);
}

// What a loop with held forces does otherwise is what the delay of (delay + 1/2) steps does: given to the components of
// the run without a loop, it leaves less than a fiftieth of the difference: the next order in the step, (w h)^2/24 of
// the force, and the error of the variable steps.
TEST(VehicleSimulation, DelayExplainsTheLoopWithHeldForces) {
  Scene scene = someTrack();
  scene.step = 500000;
  const auto components = loadedComponents();
  const History undelayed = runVariableStep(scene, components, {});
  for (const int delay : {0, 1}) {
    LibraryExchange exchange(components);
    const History loop = runExchange(scene, exchange, delay);
    const auto late = loadedComponents({{"time_delay", {{"delay", {loopDelay(0.5e-3, delay)}}}}});
    const PerStrut without = displacementDifference(loop, undelayed);
    const PerStrut with = displacementDifference(loop, runVariableStep(scene, late, {}));
    for (std::size_t i = 0; i < kStruts; ++i) {
      EXPECT_LT(with[i], 0.02 * without[i]) << strutNames()[i] << ", delay " << delay << ": " << without[i];
    }
  }
}

TEST(VehicleSimulation, AskingForTheForcesOfAStepThatWasNotSentIsRefused) {
  const auto components = loadedComponents();
  LibraryExchange exchange(components);
  exchange.send(0, {});
  EXPECT_THROW(exchange.receive(1), std::runtime_error);
  EXPECT_THROW(exchange.send(0, {}), std::runtime_error);
}

// Pitch is not coupled to the other coordinates, so its margin follows from a scalar equation, solved here by itself:
// I w^2 = 2 a^2 |K*(w)|, T = loss angle/w. With weak losses at the frame's bounce left out it is the least of all.
TEST(VehicleStability, MarginIsTheLossAngleOverTheAngularFrequency) {
  const VehicleParameters parameters;
  const auto components = loadedComponents();
  double low = 1.0;
  double high = 100.0;
  const auto excess = [&](double frequency) {
    const double omega = 2.0 * element::kPi * frequency;
    return parameters.frame_inertia * omega * omega -
           2.0 * std::pow(parameters.semi_wheelbase, 2) * std::abs(*components[0].complexStiffness(frequency));
  };
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (excess(middle) < 0.0 ? low : high) = middle;
  }
  const double margin = std::arg(*components[0].complexStiffness(low)) / (2.0 * element::kPi * low);
  const DelayMargin found = delayMargin(parameters, components);
  EXPECT_NEAR(found.frequency, low, 1e-6 * low);
  EXPECT_NEAR(found.delay, margin, 1e-6 * margin);
}

// The step beyond which a run grows is that at which the mean delay of its forces is the margin. That they are held in
// between, and not only late, changes it by about (w h)^2/24, here 0.2 %; the search ends at 1 %.
TEST(VehicleStability, RunsGrowBeyondTheMargin) {
  const VehicleParameters parameters;
  const auto components = loadedComponents();
  const double margin = delayMargin(parameters, components).delay;
  for (const int delay : {0, 1}) {
    const double limit = margin / (delay + 0.5);
    EXPECT_LT(growthRate(parameters, components, std::llround(0.97e9 * limit), delay, 4.0), 0.0);
    EXPECT_GT(growthRate(parameters, components, std::llround(1.03e9 * limit), delay, 4.0), 0.0);
  }
}

TEST(VehicleStability, NamesAComponentThatIsNotLinear) {
  const auto components = loadedComponents({{"friction", {{"maximum_force", {2000.0}}, {"displacement", {1e-3}}}}});
  EXPECT_NE(
      messageOf<std::invalid_argument>([&] { delayMargin(VehicleParameters(), components); }).find("front_primary"),
      std::string::npos);
}

}  // namespace
}  // namespace rubber_suspension::vehicle
