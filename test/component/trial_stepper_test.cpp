// Trial steps have no effect: with any number of them in between, the accepted steps give the same forces.
#include "rubber_suspension/component/trial_stepper.h"

#include "support/allocation_counter.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

component::Component bushing() {
  return component::Component(
      {spring(3e6), maxwell(1e6, 8.0), friction(6000.0, 2e-3), entry("stress_softening reduction=0.2")});
}

double displacementAt(double time) { return 2e-3 * std::sin(20.0 * time) + 3e-4 * std::sin(131.0 * time); }

TEST(TrialStepper, TrialsLeaveNothingBehind) {
  const component::Component component = bushing();
  component::TrialStepper stepper(component);
  component::ComponentState alone = component.makeState();
  stepper.initialise(1.0, 0.0);
  component.initialise(alone, 0.0);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> length(1e-4, 5e-3);
  std::uniform_real_distribution<double> off(-1e-3, 1e-3);
  double time = 1.0;
  for (int i = 0; i < 2000; ++i) {
    const double next = time + length(random);
    for (int trial = 0; trial < 3; ++trial) {
      stepper.attempt(time + length(random), displacementAt(next) + off(random));
    }
    stepper.tangent(next, displacementAt(next));
    const double expected = component.step(alone, next - time, displacementAt(next)).total;
    ASSERT_EQ(stepper.attempt(next, displacementAt(next)).total, expected) << "step " << i;
    ASSERT_EQ(stepper.accept(next, displacementAt(next)).total, expected) << "step " << i;
    time = next;
  }
}

TEST(TrialStepper, GivesTheAcceptedForceAtTheAcceptedTime) {
  const component::Component component = bushing();
  component::TrialStepper stepper(component);
  const double at_rest = stepper.initialise(0.0, 1e-3).total;
  EXPECT_EQ(stepper.attempt(0.0, 2e-3).total, at_rest);
  const double force = stepper.accept(1e-3, 2e-3).total;
  EXPECT_EQ(stepper.attempt(1e-3, 0.0).total, force);
  EXPECT_EQ(stepper.accept(1e-3, 0.0).total, force);
  EXPECT_EQ(stepper.time(), 1e-3);
}

TEST(TrialStepper, RefusesToGoBackBehindAnAcceptedStep) {
  const component::Component component = bushing();
  component::TrialStepper stepper(component);
  stepper.initialise(0.0, 0.0);
  stepper.accept(1e-3, 1e-3);
  EXPECT_THROW(stepper.attempt(0.9e-3, 0.0), std::invalid_argument);
  EXPECT_THROW(stepper.accept(0.9e-3, 0.0), std::invalid_argument);
  EXPECT_THROW(stepper.tangent(1e-3, 0.0), std::invalid_argument);
  EXPECT_THROW(stepper.attempt(std::nan(""), 0.0), std::invalid_argument);
}

TEST(TrialStepper, TangentIsTheDerivativeOfTheTrial) {
  const component::Component component({spring(3e6), dashpot(1e4)});
  component::TrialStepper stepper(component);
  stepper.initialise(0.0, 0.0);
  const component::Tangent tangent = stepper.tangent(1e-3, 1e-3);
  const double slope = (stepper.attempt(1e-3, 1.1e-3).total - stepper.attempt(1e-3, 0.9e-3).total) / 0.2e-3;
  EXPECT_NEAR(tangent.stiffness + tangent.damping / 1e-3, slope, 1e-7 * slope);
}

TEST(TrialStepper, AllocatesNothing) {
  const component::Component component = bushing();
  component::TrialStepper stepper(component);
  stepper.initialise(0.0, 0.0);
  const test::AllocationCounter counter;
  stepper.attempt(1e-3, 1e-3);
  stepper.tangent(1e-3, 1e-3);
  stepper.accept(1e-3, 1e-3);
  EXPECT_EQ(counter.count(), 0U);
}

}  // namespace
}  // namespace rubber_suspension
