// Loops: Eqs. 1 and 2, simulation compared with the closed form, and settled loops of friction.
#include "rubber_suspension/element/berg_friction.h"
#include "rubber_suspension/response/sweep.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

using Complex = std::complex<double>;

TEST(CharacteristicsOfEllipse, IsWhatTheLoopGives) {
  const auto result = response::characteristicsOfEllipse(std::polar(4.2e6, 0.1), 2e-3);
  EXPECT_DOUBLE_EQ(result.stiffness, 4.2e6);
  EXPECT_NEAR(result.loss_angle, 0.1, 1e-15);
  EXPECT_NEAR(result.loss, element::kPi * 4.2e6 * 4e-6 * std::sin(0.1), 1e-12);
}

// The loop of a contact has no loss, and rounding in the simulation must not cause one.
TEST(SettledLoop, HasNoLossBelowRounding) {
  const component::Component contact({spring(1e6), entry("lift_off side=1 slack_stiffness=0")});
  EXPECT_EQ(response::simulateSettledLoop(contact, 1.0, 1e-3).characteristics().loss_angle, 0.0);
}

// Simulates at least 4 s, in which the transient of the slowest element of kLinear decays to exp(-35).
Complex simulatedStiffness(const Entries& elements, double frequency, int samples) {
  const int cycles = static_cast<int>(std::ceil(4.0 * frequency)) + 1;
  return settledStiffness(component::Component(elements), frequency, samples, cycles);
}

// Returns the exact response of the laws to straight lines through the samples of a sine. With E = exp(i w dt), the
// recursion F+ = e F + g (z+ - z) gives F/z = g (E - 1)/(E - e). A dashpot has c (1 - 1/E)/dt.
Complex polygonStiffness(const Entries& elements, double frequency, int samples) {
  const double dt = 1.0 / (frequency * samples);
  const Complex e = std::polar(1.0, 2.0 * element::kPi / samples);
  Complex sum = 0.0;
  for (const element::ElementDescription& element : elements) {
    if (element.type == "spring") {
      sum += element.value("stiffness");
    } else if (element.type == "dashpot") {
      sum += element.value("damping") * (1.0 - 1.0 / e) / dt;
    } else {
      const double tau = 1.0 / (2.0 * element::kPi * element.value("break_frequency"));
      const double decay = std::exp(-dt / tau);
      sum += element.value("stiffness") * tau / dt * (1.0 - decay) * (e - 1.0) / (e - decay);
    }
  }
  return sum;
}

const Entries kLinear = {spring(3e6), maxwell(1.3e6, 1.4), maxwell(0.4e6, 15.0), dashpot(3000.0)};

TEST(SimulatedSine, AgreesWithTheClosedFormOfThePolygon) {
  for (const double frequency : {0.5, 4.0, 30.0}) {
    for (const int samples : {12, 100, 1000}) {
      const Complex simulated = simulatedStiffness(kLinear, frequency, samples);
      const Complex exact = polygonStiffness(kLinear, frequency, samples);
      EXPECT_LT(std::abs(simulated - exact) / std::abs(exact), 1e-10) << frequency << " Hz, " << samples;
    }
  }
}

TEST(SimulatedSine, PolygonTendsToTheSineWithTheSquareOfTheStep) {
  const Entries undashed(kLinear.begin(), kLinear.begin() + 3);
  const Complex exact = component::Component(undashed).complexStiffness(4.0).value();
  const double coarse = std::abs(simulatedStiffness(undashed, 4.0, 100) - exact);
  const double fine = std::abs(simulatedStiffness(undashed, 4.0, 200) - exact);
  EXPECT_NEAR(coarse / fine, 4.0, 0.01);
  EXPECT_LT(coarse / std::abs(exact), 1e-3);
}

TEST(SettledLoop, BergLoopIsThatOfItsFormula) {
  const struct {
    double amplitude, maximum_force, displacement;
  } rows[] = {{2.0, 1.5, 0.5}, {10.0, 1.0, 0.3}};
  for (const auto& row : rows) {
    const element::BergFriction law(row.maximum_force, row.displacement, 0.0);
    const auto loop = response::simulateSettledLoop(
        component::Component({friction(row.maximum_force, row.displacement)}), 1.0, row.amplitude);
    const auto result = loop.characteristics();
    EXPECT_TRUE(loop.settled);
    EXPECT_NEAR(result.stiffness * row.amplitude / law.settledForce(row.amplitude), 1.0, 1e-6);
    EXPECT_NEAR(result.loss / law.settledLoss(row.amplitude), 1.0, 1e-6);
  }
}

TEST(SettledLoop, WholeComponentSettlesOnTheSameLoop) {
  // With a mount in series, the whole component is simulated from rest. The mount is very stiff, so the loop equals
  // that of the parallel elements.
  Entries elements = {friction(5000.0, 2.2e-3), spring(3e6)};
  const auto direct = response::simulateSettledLoop(component::Component(elements), 4.0, 2e-3).characteristics();
  elements.push_back(entry("series_compliance stiffness=1e18"));
  const auto loop = response::simulateSettledLoop(component::Component(elements), 4.0, 2e-3);
  EXPECT_TRUE(loop.settled);
  EXPECT_GT(loop.cycles, 2);
  EXPECT_NEAR(loop.characteristics().stiffness / direct.stiffness, 1.0, 1e-7);
  EXPECT_NEAR(loop.characteristics().loss / direct.loss, 1.0, 1e-7);
}

TEST(SettledLoop, SaysWhenItHasNotSettled) {
  const Entries slow = {spring(3e6), maxwell(1e6, 1e-3), entry("series_compliance stiffness=3e7"), friction(1e3, 1e-4)};
  response::LoopOptions options;
  options.maximum_cycles = 5;
  EXPECT_FALSE(response::simulateSettledLoop(component::Component(slow), 4.0, 2e-3, options).settled);
  EXPECT_FALSE(response::characteristicsAt(component::Component(slow), 4.0, 2e-3, options).settled);
  const auto loop = response::simulateSettledLoop(component::Component(slow), 4.0, 2e-3);
  EXPECT_TRUE(loop.settled);
  // tau = 159 s takes 637 cycles. The transient needs about twenty tau to decay to 1e-9 of the force.
  EXPECT_GT(loop.cycles, 5 * 637);
}

TEST(SettledLoop, RefusesWhatMakesNoLoop) {
  const component::Component component({friction(1.0, 1.0)});
  EXPECT_THROW(response::simulateSettledLoop(component, 0.0, 1.0), std::invalid_argument);
  EXPECT_THROW(response::simulateSettledLoop(component, NAN, 1.0), std::invalid_argument);
  EXPECT_THROW(response::simulateSettledLoop(component, 1.0, -1.0), std::invalid_argument);
  response::LoopOptions options;
  options.samples = 10;
  EXPECT_THROW(response::simulateSettledLoop(component, 1.0, 1.0, options), std::invalid_argument);
}

TEST(Sweep, LinearComponentIsItsClosedForm) {
  const component::Component component(kLinear);
  for (const response::SweepPoint& point :
       response::sweepFrequency(component, response::logSpaced(0.01, 100.0, 20), 1e-3)) {
    const Complex exact = component.complexStiffness(point.frequency).value();
    EXPECT_NEAR(point.characteristics.stiffness / std::abs(exact), 1.0, 1e-14);
    EXPECT_NEAR(point.characteristics.loss_angle, std::arg(exact), 1e-14);
  }
}

TEST(Sweep, FrictionSoftensWithAmplitudeAndNotWithFrequency) {
  const component::Component component({friction(5000.0, 2.2e-3)});
  double before = HUGE_VAL;
  for (const response::SweepPoint& point :
       response::sweepAmplitude(component, response::logSpaced(1e-5, 1e-2, 7), 4.0)) {
    EXPECT_LT(point.characteristics.stiffness, before);
    before = point.characteristics.stiffness;
  }
  const auto over_frequency = response::sweepFrequency(component, {0.1, 10.0}, 1e-3);
  EXPECT_DOUBLE_EQ(over_frequency[0].characteristics.stiffness, over_frequency[1].characteristics.stiffness);
}

TEST(Sweep, ConstantProduct) {
  const auto points = response::sweepConstantProduct(component::Component(kLinear), {1.0, 4.0, 20.0}, 8e-3);
  EXPECT_DOUBLE_EQ(points[0].amplitude, 8e-3);
  EXPECT_DOUBLE_EQ(points[1].amplitude, 2e-3);
  EXPECT_DOUBLE_EQ(points[2].amplitude, 0.4e-3);
}

TEST(LogSpaced, EndsAreExact) {
  const auto values = response::logSpaced(0.1, 40.0, 5);
  EXPECT_EQ(values.size(), 5u);
  EXPECT_EQ(values.front(), 0.1);
  EXPECT_EQ(values.back(), 40.0);
  EXPECT_NEAR(values[2], 2.0, 1e-12);
}

}  // namespace
}  // namespace rubber_suspension
