// Elements between rig and specimen, and effects that scale the force of the specimen: closed forms and limits.
#include "element/driver.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

using Joint = std::shared_ptr<const element::SeriesElement>;

Joint jointOf(const element::ElementDescription& description) {
  return std::get<Joint>(element::makeElement(description));
}

TEST(SeriesCompliance, HalvesAtItsClosingForceAndClosesNoMoreThanTheHyperbola) {
  const Joint joint = jointOf(entry("series_compliance stiffness=2e7 closing_force=500"));
  EXPECT_DOUBLE_EQ(joint->deflection(500.0), 0.5 * 500.0 / 2e7);
  EXPECT_DOUBLE_EQ(joint->deflection(-500.0), -0.5 * 500.0 / 2e7);
  EXPECT_NEAR(joint->deflection(1e-6) / (1e-6 / 2e7), 1.0, 1.01 * 1e-6 / 500.0);  // first term of the expansion
  EXPECT_NEAR(joint->deflection(5e9) / (500.0 / 2e7), 1.0, 1.01e-7);              // asymptote 1 - F_c/F
  EXPECT_FALSE(joint->compliance());
}

TEST(SeriesCompliance, OfOneSideYieldsToOneSignOfForceAlone) {
  for (const double side : {1.0, -1.0, 0.0}) {
    const Joint joint = jointOf(entry("series_compliance stiffness=2e7", {{"side", side}}));
    const double tension = side >= 0.0 ? 1.0 / 2e7 : 0.0;
    const double compression = side <= 0.0 ? 1.0 / 2e7 : 0.0;
    EXPECT_DOUBLE_EQ(joint->deflection(300.0), 300.0 * tension) << side;
    EXPECT_DOUBLE_EQ(joint->deflection(-300.0), -300.0 * compression) << side;
    EXPECT_EQ(joint->compliance()->tension, tension) << side;
    EXPECT_EQ(joint->compliance()->compression, compression) << side;
  }
}

TEST(SeriesCompliance, NeverYieldsLessToALargerForce) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> decade(-6.0, 9.0);
  for (int i = 0; i < 2000; ++i) {
    const Joint joint = jointOf(entry("series_compliance", {{"stiffness", std::pow(10.0, decade(random))},
                                                            {"closing_force", std::pow(10.0, decade(random))},
                                                            {"side", i % 3 - 1.0}}));
    const double force = (i % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, decade(random));
    const double larger = force + std::pow(10.0, decade(random));
    // The tolerance is twice the rounding of F/(K_s (1 + F/F_c)) at the larger force.
    const double rounding = 1e-15 * std::abs(joint->deflection(larger));
    ASSERT_GE(joint->deflection(larger), joint->deflection(force) - rounding) << i;
    ASSERT_GE(joint->deflection(force) * force, 0.0) << i;
  }
}

TEST(Inertia, IsExactForACubicAtUnequalSteps) {
  Driver driver("inertia mass=12");
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> dt(0.01, 0.1);
  double t = 0.0;
  for (int i = 0; i < 50; ++i) {
    const double step = dt(generator);
    t += step;
    const double force = driver.step(step, t * t * (2.0 - 3.0 * t));
    if (i >= 3) {  // the acceleration jumps at the start
      EXPECT_NEAR(force, 12.0 * (4.0 - 18.0 * t), 1e-6 * std::max(1.0, t * t * t)) << i;
    }
  }
}

/// Returns the first harmonic of the force under a sine of 30 Hz, divided by the displacement and by K*.
std::complex<double> settledShare(const std::string& law, int samples, int cycles) {
  Driver driver(law);
  const auto step = [&](double dt, double displacement) { return driver.step(dt, displacement); };
  return settledStiffness(30.0, samples, cycles, 1.0, step) / *driver.law().complexStiffness(2.0 * element::kPi * 30.0);
}

TEST(Inertia, SineIsInPhaseToSecondOrder) {
  const std::complex<double> ratio = settledShare("inertia mass=12", 100, 2);
  const double step_angle = 2.0 * element::kPi / 100.0;
  EXPECT_NEAR(ratio.real() - 1.0, 11.0 / 12.0 * step_angle * step_angle, 0.01 * step_angle * step_angle);
  EXPECT_NEAR(ratio.imag(), 0.0, 2.0 * std::pow(step_angle, 3));
}

// The first harmonic of n straight lines per period is (pi/n)^2/3 lower. After two periods, transients are exp(-60).
TEST(SmoothedInertia, SineIsAsItsFilterSays) {
  EXPECT_NEAR(std::abs(settledShare("inertia mass=12 bandwidth=80", 1000, 3) - 1.0), 0.0, 5e-6);
}

TEST(SmoothedInertia, MakesLittleForceOfNoise) {
  constexpr double kStep = 2e-3;
  Driver driver(entry("inertia mass=1", {{"bandwidth", 1.0 / (2.0 * element::kPi * kStep)}}));
  std::mt19937 generator(11);
  std::normal_distribution<double> noise(0.0, kStep * kStep);
  double sum = 0.0;
  constexpr int kSamples = 20000;
  for (int i = 0; i < kSamples; ++i) {
    sum += std::pow(driver.step(kStep, noise(generator)), 2);
  }
  // The impulse response gives this value. The tolerance is 5 times the scatter of 20,000 samples.
  EXPECT_NEAR(std::sqrt(sum / kSamples), 0.866, 0.05 * 0.866);
}

TEST(ForceOffset, IsThereFromTheStart) {
  Driver driver("force_offset offset=-150");
  EXPECT_EQ(driver.output(), -150.0);
  EXPECT_EQ(driver.step(1.0, 3e-3), -150.0);
}

TEST(ForceDrift, GrowsWithTimeAlone) {
  Driver driver("force_drift rate=2.5", 1e-3);
  EXPECT_EQ(driver.output(), 0.0);
  driver.step(1.0, 3e-3);
  EXPECT_DOUBLE_EQ(driver.step(3.0, -1.0), 10.0);
}

TEST(FreePlay, LosesTheMotionWithinTheGapOrAShareOfIt) {
  EXPECT_DOUBLE_EQ(Driver("free_play gap=2e-4", 1e-3).output(), 8e-4);
  EXPECT_DOUBLE_EQ(Driver("free_play gap=2e-4", -1e-3).output(), -8e-4);
  EXPECT_DOUBLE_EQ(Driver("free_play gap=2e-4 share=0.25", 1e-4).output(), 0.75e-4);
  EXPECT_DOUBLE_EQ(Driver("free_play gap=2e-4 share=0.25", -1e-3).output(), -0.95e-3);
}

TEST(TimeDelay, LineIsExactAtUnequalSteps) {
  Driver driver("time_delay delay=7e-3");
  std::mt19937 generator(6);
  std::uniform_real_distribution<double> dt(1e-4, 4e-3);
  double t = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double step = dt(generator);
    t += step;
    EXPECT_NEAR(driver.step(step, 2.0 * t), 2.0 * std::max(0.0, t - 7e-3), 1e-12);
  }
}

// The displacement is linear between samples, even if an earlier step is much longer than the delay.
TEST(TimeDelay, ReproducesTheBentLineBetweenSamples) {
  Driver driver("time_delay delay=0.05", 1.0);
  EXPECT_DOUBLE_EQ(driver.step(0.04, 2.0), 1.0) << "before the start at rest";
  EXPECT_DOUBLE_EQ(driver.step(1.0, 5.0), 5.0 - 3.0 * 0.05);
  EXPECT_NEAR(driver.step(0.02, 0.0), 5.0 - 3.0 * 0.03, 1e-12);
  EXPECT_NEAR(driver.step(0.04, 0.0), 5.0 - 5.0 * 0.01 / 0.02, 1e-12);
}

// At 20 kHz, a delay of 50 ms would need 1000 samples. The ring buffer stores 256, and omits samples between them.
TEST(TimeDelay, ThinsWhereTheRingWouldBeTooShort) {
  constexpr double kDelay = 0.05;
  constexpr double kFine = 5e-5;
  constexpr double kOmega = 2.0 * element::kPi * 10.0;
  Driver driver("time_delay delay=0.05");
  const double chord = std::pow(kOmega * (kDelay / 126.0), 2) / 8.0;
  for (int i = 1; i < 20000; ++i) {
    const double behind = driver.step(kFine, 1.0 - std::cos(kOmega * kFine * i));
    const double expected = 1.0 - std::cos(kOmega * std::max(0.0, kFine * i - kDelay));
    ASSERT_NEAR(behind, expected, chord + 1e-9) << i;
  }
}

TEST(TimeDelay, NegativeDelayCarriesForwardAlongALine) {
  Driver driver("time_delay delay=-2e-3");
  EXPECT_DOUBLE_EQ(driver.step(1e-3, 1.0), 3.0);
  EXPECT_DOUBLE_EQ(driver.step(4e-3, 3.0), 4.0);
  constexpr double kOmega = 2.0 * element::kPi * 10.0;
  const component::Component component({spring(1.0), entry("time_delay delay=-2e-3")});
  EXPECT_NEAR(std::abs(*component.complexStiffness(10.0) - std::polar(1.0, kOmega * 2e-3)), 0.0,
              std::pow(kOmega * 2e-3, 2) / 2.0);
}

/// Steps a single effect that scales forces, with a default step of 1 s.
class Effect {
 public:
  explicit Effect(const std::string& text) : law_(std::get<Pointer>(element::makeElement(entry(text)))) {
    law_->initialise(0.0, memory_);
  }

  double step(double z, const element::ComponentForce& force = {}, double dt = 1.0) {
    const double increment = z - z_;
    z_ = z;
    return law_->step({dt, z, increment}, force, memory_);
  }
  double relax() { return law_->relax(0.0, memory_); }
  double reach() const { return memory_[0]; }
  double reachSoftened() const { return memory_[1]; }

 private:
  using Pointer = std::shared_ptr<const element::ForceEffect>;
  Pointer law_;
  double memory_[2] = {};
  double z_ = 0.0;
};

/// Returns the softening factor at a displacement after a larger displacement `reach`.
double factorAt(const std::string& text, double displacement, double reach) {
  Effect effect(text);
  effect.step(reach);
  return effect.step(displacement);
}

TEST(StressSoftening, SoftensOnlyWithinWhatWasReachedAndStaysThroughARest) {
  Effect effect("stress_softening reduction=0.3 width=0.2");
  EXPECT_EQ(effect.step(1e-3), 1.0) << "first loading";
  EXPECT_EQ(effect.step(2e-3), 1.0);
  EXPECT_LT(effect.step(1e-3), 0.75) << "second loading";
  EXPECT_NEAR(effect.step(0.0), 0.7, 1e-12) << "all of the reduction";
  EXPECT_LT(effect.step(-1e-3), 0.75) << "symmetric";
  EXPECT_EQ(effect.step(2e-3), 1.0) << "regained at the largest displacement";
  EXPECT_EQ(effect.step(2.5e-3), 1.0);
  EXPECT_NEAR(effect.relax(), 0.7, 1e-12);
  EXPECT_LT(effect.step(1e-3), 0.75) << "after the rest";
}

// With reduction R and width w, the slope is at most R 2/w, also on one side only. A step is a 200th of the reach.
TEST(StressSoftening, FactorIsMonotoneAndContinuous) {
  double before = factorAt("stress_softening reduction=0.3 width=0.5", 0.0, 2.0);
  EXPECT_NEAR(before, 0.7, 1e-12);
  for (int i = 1; i <= 200; ++i) {
    const double factor = factorAt("stress_softening reduction=0.3 width=0.5", 0.01 * i, 2.0);
    EXPECT_GE(factor, before);
    EXPECT_LT(factor - before, 0.02);
    before = factor;
  }
  EXPECT_EQ(before, 1.0);
  const std::string upper = "stress_softening reduction=0.3 width=0.2 side=1";
  before = factorAt(upper, -1e-3, 2e-3);
  for (int i = 1; i <= 300; ++i) {
    const double factor = factorAt(upper, -1e-3 + 1e-5 * i, 2e-3);
    EXPECT_LT(std::abs(factor - before), 0.016) << "no jump";
    before = factor;
  }
}

// With a wide transition, tanh x is x up to x^3/3, so the reduction falls linearly with the displacement.
TEST(StressSoftening, MayCountDisplacementInPlaceOfEnergy) {
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    EXPECT_NEAR(factorAt("stress_softening reduction=0.3 width=10 ratio_power=1", share * 2e-3, 2e-3),
                1.0 - 0.3 * (1.0 - share), 0.3 * 4e-3);
  }
}

TEST(StressSoftening, PathMakesItTakeSomeCycles) {
  constexpr double kReach = 1e-3;
  Effect effect("stress_softening reduction=0.3 width=0.2 path=4e-3");  // the length of one cycle with that amplitude
  effect.step(kReach);
  double remaining = kReach - effect.reachSoftened();
  for (int cycle = 0; cycle < 5; ++cycle) {
    effect.step(-kReach);
    effect.step(kReach);
    const double now = kReach - effect.reachSoftened();
    EXPECT_NEAR(now / remaining, std::exp(-1.0), 1e-12) << cycle;
    remaining = now;
  }
}

TEST(StressSoftening, GrowsWithTheReachUpToFullReach) {
  const std::string law = "stress_softening reduction=0.4 width=0.2 reach_exponent=2 full_reach=4e-3";
  EXPECT_NEAR(factorAt(law, 0.0, 2e-3), 1.0 - 0.4 * 0.25, 1e-12) << "half of the reach, a quarter of the reduction";
  EXPECT_NEAR(factorAt(law, 0.0, 4e-3), 0.6, 1e-12);
  EXPECT_NEAR(factorAt(law, 0.0, 8e-3), 0.6, 1e-12) << "no more beyond";
}

TEST(StressSoftening, OfOneSideLeavesTheOtherAlone) {
  Effect effect("stress_softening reduction=0.3 width=0.2 side=1");
  EXPECT_EQ(effect.step(-3e-3), 1.0) << "does not count";
  EXPECT_EQ(effect.step(2e-3), 1.0) << "first loading to this side";
  EXPECT_LT(effect.step(1e-3), 0.75);
  EXPECT_NEAR(effect.step(0.0), 0.85, 1e-12) << "half of it at zero";
  EXPECT_EQ(effect.step(-0.6e-3), 1.0) << "beyond a quarter of the reach";
}

// Over the recovery time, the reach falls by a factor of e. Steps are 1 s long.
TEST(StressSoftening, RecoversAtRest) {
  Effect effect("stress_softening reduction=0.3 width=0.2 recovery_time=10");
  effect.step(2e-3);
  for (int i = 0; i < 10; ++i) {
    effect.step(0.0);
  }
  EXPECT_NEAR(effect.reach(), 2e-3 * std::exp(-1.0), 1e-12);
  EXPECT_EQ(effect.step(1e-3), 1.0) << "beyond what is left of the reach";
  EXPECT_EQ(effect.relax(), 1.0) << "a long rest heals it";
  EXPECT_EQ(effect.reach(), 0.0);
}

// With a loss force F at speed v, sensitivity s and time constant T, softening x obeys dx/dt = s F v (1 - x) - x/T.
TEST(SelfHeating, SettlesAtTheBalanceOfHeat) {
  Effect effect("self_heating energy_sensitivity=1e-3 time_constant=20");
  element::ComponentForce force;
  force.friction = 1e3;
  force.elastic = 1e9;  // causes no heat
  double factor = 1.0;
  for (int i = 1; i <= 100000; ++i) {
    factor = effect.step(0.01 * 0.02 * i, force, 0.01);
  }
  const double gain = 1e-3 * 20.0 * (1e3 * 0.02);  // s T P = 0.4 for the power P of the force without softening
  EXPECT_NEAR(factor, 1.0 - gain / (1.0 + gain), 1e-9);
  force.friction = 0.0;
  effect.step(20.0, force, 1e-9);
  EXPECT_NEAR(1.0 - effect.step(20.0, force, 20.0), gain / (1.0 + gain) * std::exp(-1.0), 1e-6) << "cools at rest";
}

TEST(SelfHeating, TakesUpTheEnergyLostIfNothingCools) {
  Effect effect("self_heating energy_sensitivity=1e-6 time_constant=1e12");
  element::ComponentForce force;
  force.viscous = 500.0;
  double factor = 1.0;
  for (int i = 1; i <= 1000; ++i) {
    factor = effect.step(1e-3 * i, force, 0.01);
  }
  // The work is 500 N over 1 m, less half of the first step, where the force rises from 0. Mean softening is 2.5e-4.
  EXPECT_NEAR(1.0 - factor, 1e-6 * 500.0 * 0.9995, 1e-3 * 1e-6 * 500.0);
}

TEST(SelfHeating, KeepsAFifthAtLeast) {
  element::ComponentForce force;
  force.viscous = 1e6;
  EXPECT_EQ(Effect("self_heating energy_sensitivity=1e3 time_constant=1e9").step(1.0, force), 0.2);
}

}  // namespace
}  // namespace rubber_suspension::test
