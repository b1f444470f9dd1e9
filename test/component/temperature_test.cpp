// Temperature: shifted dynamic stiffness and master curve, reduced time under a changing temperature, elements with a
// time of their own, and components without a temperature law.
#include "element/typical_elements.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/component/sample_stream.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/temperature_shift.h"
#include "support/allocation_counter.h"
#include "support/kit.h"

namespace rubber_suspension::test {
namespace {

const element::ElementDescription kSpring = spring(3e6);
const element::ElementDescription kDashpot = dashpot(1e4);
const element::ElementDescription kMaxwell = maxwell(1.3e6, 1.43);
const element::ElementDescription kSpringpot = entry("springpot stiffness=1e6 order=0.2");
const element::ElementDescription kFriction = friction(5e3, 1e-3);
const element::ElementDescription kMass = entry("inertia mass=12");
const element::ElementDescription kMount = entry("series_compliance stiffness=3e7");
const element::ElementDescription kDelay = entry("time_delay delay=1e-3");
const element::ElementDescription kHeating = entry("self_heating energy_sensitivity=1e-3 time_constant=20");

constexpr double kReference = 20.0;  // [degC]

// Returns the constants of natural rubber, with the vertical shift of entropic elasticity.
element::ElementDescription wlf(double vertical = 1.0 / 293.15) {
  return entry("wlf_shift c1=8.86 c2=101.6", {{"reference", kReference}, {"vertical", vertical}});
}

// Returns the shift factors of wlf(), computed separately.
element::Shift factorsAt(double temperature) {
  const double above = temperature - kReference;
  return {std::pow(10.0, -8.86 * above / (101.6 + above)), (temperature + 273.15) / 293.15};
}

double displacementAt(int i) { return 1e-3 * std::sin(0.013 * i) + 4e-4 * std::sin(0.11 * i); }

// Returns the forces of a motion from rest at a constant temperature.
std::vector<double> forces(const component::Component& component, double temperature, double dt, int count) {
  component::ComponentState state = component.makeState();
  component.setTemperature(state, temperature);
  component.initialise(state, 0.0);
  std::vector<double> result;
  for (int i = 1; i <= count; ++i) {
    result.push_back(component.step(state, dt, displacementAt(i)).total);
  }
  return result;
}

// At a constant temperature, rates are scaled by a_T and the force by b_T. So for every law, steps of dt/a_T at the
// reference temperature give the forces divided by b_T. The tolerance covers the rounding of factors and products.
TEST(Temperature, ShiftsEveryLawAlike) {
  constexpr double kDt = 1e-3;
  for (const element::ElementDescription& law : typicalElements()) {
    if (!addsForce(law) || element::lawOf(element::makeElement(law)).onRig() || law.type == "self_heating") {
      continue;
    }
    for (const double temperature : {-20.0, 20.0, 63.5}) {
      const element::Shift shift = factorsAt(temperature);
      const std::vector<double> shifted = forces(component::Component({law, wlf()}), temperature, kDt, 500);
      const std::vector<double> reference = forces(component::Component({law}), kReference, kDt / shift.time, 500);
      double largest = 0.0;
      for (const double force : reference) {
        largest = std::max(largest, std::abs(force));
      }
      for (std::size_t i = 0; i < shifted.size(); ++i) {
        ASSERT_NEAR(shifted[i], shift.force * reference[i], 1e-12 * shift.force * largest) << law.type;
      }
    }
  }
}

TEST(Temperature, DynamicStiffnessFollowsTheMasterCurve) {
  const Entries laws = {kSpring, kDashpot, kMaxwell, kSpringpot};
  const component::Component master(laws);
  const component::Component component(laws + Entries{wlf()});
  for (const double temperature : {-30.0, 0.0, 20.0, 45.0, 80.0}) {
    const element::Shift shift = factorsAt(temperature);
    for (const double frequency : {0.01, 1.0, 30.0}) {
      const std::complex<double> expected = shift.force * *master.complexStiffness(shift.time * frequency);
      const std::complex<double> stiffness = *component.complexStiffness(frequency, temperature);
      EXPECT_LE(std::abs(stiffness - expected), 1e-13 * std::abs(expected)) << temperature << " degC " << frequency;
    }
  }
  EXPECT_EQ(*component.complexStiffness(4.0), *master.complexStiffness(4.0));
  EXPECT_EQ(*component.complexStiffness(4.0, kReference), *master.complexStiffness(4.0));
}

// A simulated sine gives K*(omega, T), with a sampling error of second order in the step.
TEST(Temperature, SimulatedSineTendsToTheShiftedStiffness) {
  const component::Component component({kSpring, kMaxwell, wlf()});
  constexpr double kFrequency = 4.0;
  constexpr double kTemperature = 5.0;
  constexpr int kCycles = 400;  // 100 s, because a_T = 34 extends the relaxation time to 4 s
  const std::complex<double> expected = *component.complexStiffness(kFrequency, kTemperature);
  std::vector<double> errors;
  for (const int samples : {100, 200}) {
    component::ComponentState state = component.makeState();
    component.setTemperature(state, kTemperature);
    component.initialise(state, 0.0);
    const auto step = [&](double dt, double z) { return component.step(state, dt, z).total; };
    errors.push_back(std::abs(settledStiffness(kFrequency, samples, kCycles, 1e-3, step) - expected));
  }
  EXPECT_LE(errors[1], 0.26 * errors[0]);
  EXPECT_LE(errors[1], 1e-3 * std::abs(expected));
}

// Rig, mount and delay are not of rubber, so the temperature shifts K* of the test piece only.
TEST(Temperature, LeavesRigMountAndDelayAlone) {
  const component::Component component({kSpring, kMaxwell, kMount, kMass, kDelay, wlf()});
  constexpr double kFrequency = 9.0;
  constexpr double kTemperature = -10.0;
  const element::Shift shift = factorsAt(kTemperature);
  const std::complex<double> rubber =
      shift.force * *component::Component({kSpring, kMaxwell}).complexStiffness(shift.time * kFrequency);
  const double omega = 2.0 * element::kPi * kFrequency;
  const std::complex<double> expected = rubber / (1.0 + rubber / 3e7) * std::polar(1.0, -omega * 1e-3) +
                                        *component::Component({kMass}).complexStiffness(kFrequency);
  EXPECT_LE(std::abs(*component.complexStiffness(kFrequency, kTemperature) - expected), 1e-12 * std::abs(expected));
}

// The closed form is for a ramp at two successive temperatures: F = b(T(t)) times the integral of k exp(-(xi(t) -
// xi(s))) dz(s), where xi is the reduced time divided by tau.
TEST(Temperature, ReducedTimeOfAChangeIsExact) {
  const component::Component component({kMaxwell, wlf()});
  constexpr double kRate = 2e-3;  // [m/s]
  constexpr double kDt = 0.05;
  const double tau = 1.0 / (2.0 * element::kPi * 1.43);
  const element::Shift cold = factorsAt(0.0);
  const element::Shift warm = factorsAt(40.0);
  component::ComponentState state = component.makeState();
  component.setTemperature(state, 0.0);
  component.initialise(state, 0.0);
  double force = 0.0;
  for (int i = 1; i <= 10; ++i) {
    force = component.step(state, kDt, i * kDt * kRate).total;
  }
  const double reduced_cold = 10 * kDt / (cold.time * tau);
  const double cold_force = -1.3e6 * kRate * cold.time * tau * std::expm1(-reduced_cold);
  EXPECT_NEAR(force, cold.force * cold_force, 1e-12 * force);
  component.setTemperature(state, 40.0);
  for (int i = 11; i <= 20; ++i) {
    force = component.step(state, kDt, i * kDt * kRate).total;
  }
  const double reduced_warm = 10 * kDt / (warm.time * tau);
  const double warm_force =
      cold_force * std::exp(-reduced_warm) - 1.3e6 * kRate * warm.time * tau * std::expm1(-reduced_warm);
  EXPECT_NEAR(force, warm.force * warm_force, 1e-12 * force);
}

TEST(Temperature, AtTheReferenceTheBitsAreThoseWithoutAShift) {
  const Entries laws = {kSpring, kDashpot, kMaxwell, kSpringpot, kFriction, kHeating};
  // The kernel does not contain self-heating, so the same general code steps both components.
  EXPECT_EQ(forces(component::Component(laws + Entries{wlf()}), kReference, 1e-3, 400),
            forces(component::Component(laws), kReference, 1e-3, 400));
}

TEST(Temperature, WithoutATemperatureNothingIsShifted) {
  const component::Component component({kSpring, kMaxwell, kHeating, wlf()});
  WithState plain({kSpring, kMaxwell, kHeating});
  component::ComponentState state = component.makeState();
  for (int i = 1; i < 200; ++i) {
    EXPECT_EQ(component.step(state, 1e-3, displacementAt(i)).total, plain.step(1e-3, displacementAt(i)));
  }
  component.setTemperature(state, 60.0);
  component.forgetTemperature(state);
  EXPECT_EQ(component.step(state, 1e-3, 0.0).total, plain.step(1e-3, 0.0));
}

TEST(Temperature, TwoShiftsMultiply) {
  const element::ElementDescription correction =
      entry("arrhenius_shift activation_energy=-8e3 vertical=-1e-3", {{"reference", kReference}});
  const component::Component component({kMaxwell, wlf(), correction});
  const element::Shift shift = factorsAt(45.0);
  const double time =
      shift.time * std::exp(-8e3 / 8.31446261815324 * (1.0 / (273.15 + 45.0) - 1.0 / (273.15 + kReference)));
  const double force = shift.force * (1.0 - 1e-3 * 25.0);
  const std::complex<double> expected = force * *component::Component({kMaxwell}).complexStiffness(time * 2.0);
  EXPECT_LE(std::abs(*component.complexStiffness(2.0, 45.0) - expected), 1e-12 * std::abs(expected));
}

TEST(Temperature, RefusesWhereTheShiftDoesNotHold) {
  const component::Component component({kMaxwell, wlf()});
  component::ComponentState state = component.makeState();
  // The lower bound is T_0 - C_2 kMostDecades/(kMostDecades + C_1).
  const double lowest = 20.0 - 101.6 * 20.0 / 28.86;
  EXPECT_DOUBLE_EQ(component.temperatures().lower, lowest);
  EXPECT_NO_THROW(component.setTemperature(state, lowest + 0.01));
  for (const double bad : {lowest - 0.01, -300.0, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(component.setTemperature(state, bad), std::invalid_argument) << bad;
  }
}

TEST(Temperature, BlocksAreSteps) {
  for (const Entries& more : {Entries{}, {kFriction, kHeating}, {kMount, kFriction}, {kMass, kDelay}}) {
    const component::Component component(Entries{kSpring, kMaxwell, wlf()} + more);
    component::ComponentState state = component.makeState();
    component::ComponentState other = state;
    std::vector<double> displacement;
    std::vector<double> temperature;
    std::vector<double> stepped;
    for (int i = 1; i <= 300; ++i) {
      displacement.push_back(displacementAt(i));
      temperature.push_back(20.0 + 5.0 * (i / 90) + (i > 200 && i < 240 ? 0.01 * i : 0.0));
      component.setTemperature(state, temperature.back());
      stepped.push_back(component.step(state, 1e-3, displacement.back()).total);
    }
    std::vector<double> at_once(stepped.size());
    component.simulate(other, 1e-3, displacement.data(), temperature.data(), at_once.size(), at_once.data());
    EXPECT_EQ(at_once, stepped);
    EXPECT_EQ(other.memory(), state.memory());
  }
}

TEST(Temperature, AllocatesNothing) {
  const component::Component component({kSpring, kMaxwell, kFriction, kMount, wlf()});
  component::ComponentState state = component.makeState();
  const AllocationCounter counter;
  for (int i = 1; i <= 100; ++i) {
    component.setTemperature(state, 20.0 + 0.1 * i);
    component.step(state, 1e-3, displacementAt(i));
  }
  EXPECT_EQ(counter.count(), 0U);
}

TEST(Temperature, IsPartOfTheStateThatIsSaved) {
  const component::Component component({kSpring, kMaxwell, wlf()});
  component::ComponentState state = component.makeState();
  component.setTemperature(state, 50.0);
  component.step(state, 1e-3, 1e-3);
  component::ComponentState restored = component.makeState();
  component.restore(restored, state.displacement(), state.memory());
  EXPECT_EQ(component.step(restored, 1e-3, 2e-3).total, component.step(state, 1e-3, 2e-3).total);
}

// After a sample with an infinite force, the state before it is restored, including the temperature.
TEST(TemperatureOfAStream, ASampleTakenBackLeavesTheStateAsItWas) {
  const element::ElementDescription stiffening = entry("progressive_stiffness quintic=1e15");
  const component::Component component({kSpring, kMaxwell, stiffening, wlf()});
  component::SampleStream disturbed(component);
  component::SampleStream stream(component);
  for (int i = 0; i < 200; ++i) {
    const double temperature = 20.0 + i / 20;
    ASSERT_TRUE(disturbed.setTemperature(temperature));
    ASSERT_TRUE(stream.setTemperature(temperature));
    if (i % 7 == 3) {
      EXPECT_EQ(disturbed.push(i * 1000000LL, 1e100).acceptance, component::Acceptance::force_not_finite);
    }
    EXPECT_EQ(disturbed.push(i * 1000000LL, displacementAt(i)).force.total,
              stream.push(i * 1000000LL, displacementAt(i)).force.total);
  }
  EXPECT_FALSE(stream.setTemperature(-200.0));
}

TEST(TemperatureOfAStream, AllSamplesAtOnceGiveTheSameBits) {
  const component::Component component({kSpring, kMaxwell, kFriction, wlf()});
  component::SampleStream stream(component);
  component::SampleStream other(component);
  std::vector<std::int64_t> stamp;
  std::vector<double> displacement;
  std::vector<double> temperature;
  std::vector<double> single;
  for (int i = 0; i < 600; ++i) {
    stamp.push_back(i * 1000000LL + (i % 50 == 7 ? 1000 : 0));
    displacement.push_back(displacementAt(i));
    temperature.push_back(20.0 + i / 150);
    ASSERT_TRUE(stream.setTemperature(temperature.back()));
    single.push_back(stream.push(stamp.back(), displacement.back()).force.total);
  }
  std::vector<double> all(single.size());
  EXPECT_EQ(other.pushAll(stamp.data(), displacement.data(), temperature.data(), all.size(), all.data()), all.size());
  EXPECT_EQ(all, single);
  temperature[300] = -150.0;
  component::SampleStream third(component);
  EXPECT_EQ(third.pushAll(stamp.data(), displacement.data(), temperature.data(), all.size(), all.data()), 300U);
}

}  // namespace
}  // namespace rubber_suspension::test
