// Loops: Eqs. 1 and 2, simulation against closed form, settled loops of friction.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "rubber_suspension/element/berg_friction.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/maxwell.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension {
namespace {

using Complex = std::complex<double>;

TEST(CharacteristicsOfEllipse, IsWhatTheLoopGives) {
  const auto result = response::characteristicsOfEllipse(std::polar(4.2e6, 0.1), 2e-3);
  EXPECT_DOUBLE_EQ(result.stiffness, 4.2e6);
  EXPECT_NEAR(result.loss_angle, 0.1, 1e-15);
  EXPECT_NEAR(result.loss, element::kPi * 4.2e6 * 4e-6 * std::sin(0.1), 1e-12);
}

// A contact makes its loop by simulation; it loses nothing, and rounding is no loss.
TEST(SettledLoop, HasNoLossBelowRounding) {
  const component::Component contact(
      {{"spring", {{"stiffness", {1e6}}}}, {"lift_off", {{"side", {1.0}}, {"slack_stiffness", {0.0}}}}});
  EXPECT_EQ(response::simulateSettledLoop(contact, 1.0, 1e-3).characteristics().loss_angle, 0.0);
}

// F/z of a component under a sampled sine that is taken as linear between samples, from a simulation to steady state.
Complex simulatedStiffness(const std::vector<element::ElementDescription>& elements, double frequency, int samples) {
  const component::Component component(elements);
  component::ComponentState state = component.makeState();
  const double dt = 1.0 / (frequency * samples);
  Complex force = 0.0;
  Complex displacement = 0.0;
  const double settling_time = 4.0;  // [s] leaves exp(-35) of the transient of the slowest element below
  const int settling_cycles = static_cast<int>(std::ceil(settling_time * frequency));
  for (int i = 1; i <= (settling_cycles + 1) * samples; ++i) {
    const double phase = 2.0 * element::kPi * (i % samples) / samples;
    const double z = std::sin(phase);
    const double f = component.step(state, dt, z).total;
    if (i > settling_cycles * samples) {
      force += f * std::polar(1.0, -phase);
      displacement += z * std::polar(1.0, -phase);
    }
  }
  return force / displacement;
}

// The exact response of the law to the polygon through the samples of a sine, at the samples: with E = exp(i w dt) the
// recursion F+ = e F + g (z+ - z) has F/z = g (E - 1)/(E - e); a dashpot has c (1 - 1/E)/dt.
Complex polygonStiffness(const std::vector<element::ElementDescription>& elements, double frequency, int samples) {
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

const std::vector<element::ElementDescription> kLinear = {
    {"spring", {{"stiffness", {3e6}}}},
    {"maxwell", {{"stiffness", {1.3e6}}, {"break_frequency", {1.4}}}},
    {"maxwell", {{"stiffness", {0.4e6}}, {"break_frequency", {15.0}}}},
    {"dashpot", {{"damping", {3000.0}}}}};

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
  const std::vector<element::ElementDescription> undashed(kLinear.begin(), kLinear.begin() + 3);
  const Complex exact = component::Component(undashed).complexStiffness(4.0).value();
  const double coarse = std::abs(simulatedStiffness(undashed, 4.0, 100) - exact);
  const double fine = std::abs(simulatedStiffness(undashed, 4.0, 200) - exact);
  EXPECT_NEAR(coarse / fine, 4.0, 0.01);
  EXPECT_LT(coarse / std::abs(exact), 1e-3);
}

std::vector<element::ElementDescription> berg(double maximum_force, double displacement) {
  return {{"friction", {{"maximum_force", {maximum_force}}, {"displacement", {displacement}}}}};
}

TEST(SettledLoop, BergLoopIsThatOfItsFormula) {
  const struct {
    double amplitude, maximum_force, displacement, peak, loss;
  } rows[] = {{2.0, 1.5, 0.5, 1.05234, 4.44002}, {10.0, 1.0, 0.3, 0.944870, 31.9131}};
  for (const auto& row : rows) {
    const element::BergFriction law(row.maximum_force, row.displacement, 0.0);
    EXPECT_NEAR(law.settledForce(row.amplitude), row.peak, 5e-6);
    EXPECT_NEAR(law.settledLoss(row.amplitude), row.loss, 1e-4);
    const auto loop = response::simulateSettledLoop(component::Component(berg(row.maximum_force, row.displacement)),
                                                    1.0, row.amplitude);
    const auto result = loop.characteristics();
    EXPECT_TRUE(loop.settled);
    EXPECT_NEAR(result.stiffness * row.amplitude / law.settledForce(row.amplitude), 1.0, 1e-6);
    EXPECT_NEAR(result.loss / law.settledLoss(row.amplitude), 1.0, 1e-6);
  }
}

TEST(SettledLoop, WholeComponentSettlesOnTheSameLoop) {
  // A mount in series puts the whole component through time, from rest; as it is too stiff to matter the loop has to
  // settle on that of the parallel path.
  auto elements = berg(5000.0, 2.2e-3);
  elements.push_back({"spring", {{"stiffness", {3e6}}}});
  const auto direct = response::simulateSettledLoop(component::Component(elements), 4.0, 2e-3).characteristics();
  elements.push_back({"series_compliance", {{"stiffness", {1e18}}}});
  const auto loop = response::simulateSettledLoop(component::Component(elements), 4.0, 2e-3);
  EXPECT_TRUE(loop.settled);
  EXPECT_GT(loop.cycles, 2);
  EXPECT_NEAR(loop.characteristics().stiffness / direct.stiffness, 1.0, 1e-7);
  EXPECT_NEAR(loop.characteristics().loss / direct.loss, 1.0, 1e-7);
}

TEST(SettledLoop, SaysWhenItHasNotSettled) {
  const std::vector<element::ElementDescription> slow = {
      {"spring", {{"stiffness", {3e6}}}},
      {"maxwell", {{"stiffness", {1e6}}, {"break_frequency", {1e-3}}}},
      {"series_compliance", {{"stiffness", {3e7}}}},
      {"friction", {{"maximum_force", {1e3}}, {"displacement", {1e-4}}}}};
  response::LoopOptions options;
  options.maximum_cycles = 5;
  EXPECT_FALSE(response::simulateSettledLoop(component::Component(slow), 4.0, 2e-3, options).settled);
  EXPECT_FALSE(response::characteristicsAt(component::Component(slow), 4.0, 2e-3, options).settled);
  const auto loop = response::simulateSettledLoop(component::Component(slow), 4.0, 2e-3);
  EXPECT_TRUE(loop.settled);
  // tau = 159 s is 637 cycles; a part 1e-9 of the force takes about twenty of them.
  EXPECT_GT(loop.cycles, 5 * 637);
}

TEST(SettledLoop, RefusesWhatMakesNoLoop) {
  const component::Component component(berg(1.0, 1.0));
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
  const component::Component component(berg(5000.0, 2.2e-3));
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
