// Friction laws whose limits vary, slide, flow or act behind a play, and the force during a first loading.
#include "element/driver.h"
#include "element/implicit_flow.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

constexpr double kStiffness = 1e6;  // stiffness of all laws here [N/m]

TEST(VariableFriction, LimitGrowsWithDisplacementToEitherSide) {
  Driver driver("variable_friction stiffness=1e6 yield_displacement=4e-4 growth_displacement=1e-3");
  EXPECT_NEAR(driver.step(0.01, 2e-3), 3.0 * 400.0, 1e-9);
  EXPECT_NEAR(driver.step(0.01, -4e-3), -5.0 * 400.0, 1e-9);
}

// Over the distance `travel`, sliding reduces the maximum force by a factor of e. A rest does not restore it.
TEST(VariableFriction, WearsAlongTheTravelForGood) {
  Driver driver("variable_friction stiffness=1e6 yield_displacement=4e-4 travel=0.05");
  EXPECT_NEAR(driver.step(0.01, 0.05), 400.0 * std::exp(-1.0), 1e-9);
  driver.step(100.0, 0.05);
  driver.relax();
  EXPECT_NEAR(driver.memory()[1], std::exp(-1.0), 1e-12);
}

TEST(VariableFriction, NoiseWithinTheDeadBandWearsNothing) {
  Driver driver("variable_friction stiffness=1e6 yield_displacement=4e-4 travel=0.05 dead_band=1e-5");
  driver.step(0.01, 0.05);
  const double worn = driver.memory()[1];
  for (int i = 0; i < 1000; ++i) {
    driver.step(0.01, 0.05 - (i % 2 == 0 ? 9e-6 : 0.0));
  }
  EXPECT_EQ(driver.memory()[1], worn);
  EXPECT_NEAR(worn, std::exp(-1.0), 1e-4);
}

TEST(VariableFriction, BuildsUpAtRest) {
  Driver driver("variable_friction stiffness=1e6 yield_displacement=4e-4 travel=2e-3 build_up_time=0.5");
  driver.step(20.0, 0.2);
  driver.step(100.0, 0.2);
  EXPECT_NEAR(driver.memory()[1], 1.0, 1e-12);
}

// The 1e6 explicit steps of the reference have an error of 1e-5, the 4000 implicit steps one of 3e-3 of the limit.
TEST(ViscoplasticFriction, StepsSolveTheEquation) {
  Driver driver("viscoplastic_friction stiffness=1e6 yield_displacement=4e-4 half_rate=5e-3");
  constexpr int kSteps = 4000;
  constexpr int kParts = 250;
  constexpr double kDt = 1.0 / kSteps;
  const auto motion = [](double time) { return 3e-3 * std::sin(2.0 * element::kPi * time); };
  double force = 0.0;
  double largest = 0.0;
  for (int i = 1; i <= kSteps; ++i) {
    for (int part = 0; part < kParts; ++part) {
      const double time = (i - 1) * kDt + part * kDt / kParts;
      const double increment = motion(time + kDt / kParts) - motion(time);
      force += kStiffness * (increment - kDt / kParts * 5e-3 * force / (400.0 - std::abs(force)));
    }
    EXPECT_NEAR(driver.step(kDt, motion(i * kDt)), force, 3e-3 * 400.0) << i;
    largest = std::max(largest, driver.output());
  }
  EXPECT_GT(largest, 0.7 * 400.0) << "the motion brings it near its limit";
}

TEST(ViscoplasticFriction, StaysBelowItsLimitInAnyStep) {
  Driver driver("viscoplastic_friction stiffness=1e6 yield_displacement=4e-4 half_rate=5e-3");
  for (const double z : {1.0, -1e6, 3e-9, 1e6, 0.0}) {
    for (const double dt : {1e-6, 1.0, 1e6}) {
      EXPECT_LE(std::abs(driver.step(dt, z)), 400.0) << z << ' ' << dt;
    }
  }
  EXPECT_NEAR(driver.output(), 0.0, 1e-3 * 400.0) << "at rest its force is lost";
}

TEST(FlowRoot, SolvesItsEquation) {
  for (const double m : {0.3, 0.5, 0.8, 1.0, 1.6, 2.0, 7.0}) {
    for (const double b : {0.0, 1e-9, 0.1, 30.0, 1e9}) {
      for (const double r : {0.0, 1e-12, 0.2, 5.0, 1e6}) {
        const double x = element::flowRoot(r, b, m);
        EXPECT_GE(x, 0.0);
        EXPECT_NEAR(x + b * std::pow(x, m), r, 1e-12 * r) << m << ' ' << b << ' ' << r;
      }
    }
  }
}

TEST(Overstress, KeepsItsLimitInAHold) {
  Driver driver("overstress stiffness=1e6 yield_displacement=2e-4 reference_rate=0.01 power=2");
  driver.walk(1.0, 0.01, 1000);
  driver.walk(1e4, 0.01, 1000);  // after a time t, x' = -v_r/y x^2 has decayed to y/(v_r t) = 2e-6 of the limit
  EXPECT_NEAR(driver.output(), 200.0, 1e-5 * 200.0);
}

TEST(FrictionBehindPlay, IsMissingOverTwiceTheGapAfterAReversal) {
  Driver driver("friction_behind_play stiffness=1e6 yield_displacement=4e-4 gap=2e-4");
  EXPECT_EQ(driver.step(0.01, 1e-4), 0.0);
  EXPECT_NEAR(driver.step(0.01, 2e-3), 400.0, 1e-9) << "slides";
  EXPECT_NEAR(driver.step(0.01, 1.6e-3), 0.0, 1e-9) << "contact lost after 0.4 mm";
  EXPECT_EQ(driver.step(0.01, 1.4e-3), 0.0);
  EXPECT_NEAR(driver.step(0.01, 1.2e-3 - 1e-4), -100.0, 1e-9) << "contact on the other side after 0.4 mm more";
}

// With amplitude A and gap g the loss is 4 k y (A - g - y). Each trapezoid spans 1/4000 of a stroke.
TEST(FrictionBehindPlay, LosesWhatItsFormulaSays) {
  Driver driver("friction_behind_play stiffness=1e6 yield_displacement=4e-4 gap=2e-4");
  EXPECT_NEAR(settledWork(driver, 2e-3, 2, 4000), 4.0 * 400.0 * (2e-3 - 6e-4), 1e-6);
}

// In steady motion the force is k tau v (Maxwell) or k y (power dashpot). After a reversal it falls to 0 in the gap.
TEST(DamperBehindPlay, IsMissingAfterAReversal) {
  for (const auto& [law, force, tolerance] :
       {std::tuple("maxwell_behind_play stiffness=1e6 break_frequency=200 gap=1e-3",
                   kStiffness * 0.05 / (2.0 * element::kPi * 200.0), 1e-9),
        {"power_dashpot_behind_play stiffness=1e6 displacement=1e-4 reference_rate=0.05 exponent=2 gap=1e-3", 100.0,
         1e-6}}) {
    Driver driver(law);
    driver.walk(1.0, 0.05, 1000);
    EXPECT_NEAR(driver.output(), force, tolerance) << law;
    driver.walk(0.02, 0.049, 20);
    EXPECT_EQ(driver.output(), 0.0) << law << ": 1 mm after the reversal";
    driver.walk(0.98, 0.0, 980);
    EXPECT_NEAR(driver.output(), -force, tolerance) << law;
  }
}

// With d' = -v_r sqrt(d/y), the root of d falls at a rate of v_r/(2 sqrt(y)). With steps of 1e-6 s, the error of the
// implicit method is 2.5e-5 of 100 N, half a step at this rate.
TEST(PowerDashpotBehindPlay, SlowsDownInClosedForm) {
  Driver driver("power_dashpot_behind_play stiffness=1e6 displacement=1e-4 reference_rate=0.05 exponent=2 gap=1e-3");
  driver.walk(1.0, 0.05, 1000);
  driver.walk(1e-3, 0.05, 1000);
  EXPECT_NEAR(driver.output(), 100.0 * std::pow(1.0 - 0.05 * 1e-3 / 2e-4, 2), 0.01);
}

TEST(FirstLoading, CarriesItsShareOfTheDisplacementFromZeroOn) {
  Driver driver("first_loading stiffness=1e6 yield_share=0.25");
  for (const double z : {1e-4, 1e-3, 2.5e-3}) {
    // The solution of dd/dz = 1 - d/(b z) is d = b z/(1 + b).
    EXPECT_NEAR(driver.step(0.01, z), kStiffness * 0.2 * z, 1e-9);
  }
  EXPECT_NEAR(driver.step(0.01, 2e-3 + 1e-9), kStiffness * 1e-9, 1e-6) << "returns along a spring";
  EXPECT_EQ(driver.step(0.01, 1e-3), 0.0) << "nothing within what was reached";
  EXPECT_NEAR(driver.step(0.01, -1e-3), -kStiffness * 0.2e-3, 1e-9) << "the other side is new";
}

// Euler's method with steps of 1e-5 of the displacement has an error far below the tolerance.
TEST(FirstLoading, FollowsItsEquationFromAReachOn) {
  Driver driver("first_loading stiffness=1e6 yield_share=0.1");
  driver.step(0.01, 1e-3);
  driver.step(0.01, 0.0);
  double reach = driver.memory()[0];
  constexpr double kStep = 1e-8;
  double z = reach;
  while (z < 2e-3) {
    reach += kStep * (z - reach) / (0.1 * z);
    z += kStep;
  }
  EXPECT_NEAR(driver.step(0.01, z), kStiffness * (z - reach), 1e-3 * kStiffness * (z - reach));
}

TEST(FirstLoading, IsLostWithinSomeCyclesAndKeepsItsReachAtRest) {
  Driver driver("first_loading stiffness=1e6 yield_share=0.2");
  const double first = driver.step(0.01, 1e-3);
  double last = first;
  for (int cycle = 1; cycle < 10; ++cycle) {
    driver.step(0.01, -1e-3);
    const double peak = driver.step(0.01, 1e-3);
    EXPECT_LT(peak, last) << cycle;
    last = peak;
  }
  EXPECT_LT(last, 0.2 * first);
  driver.step(0.01, 0.0);
  const double reach = driver.memory()[0];
  EXPECT_EQ(driver.relax(), 0.0);
  EXPECT_EQ(driver.memory()[0], reach);
}

TEST(FirstLoading, OfOneSideLeavesTheOtherAlone) {
  Driver driver("first_loading stiffness=1e6 yield_share=0.2 side=-1");
  EXPECT_EQ(driver.step(0.01, 1e-3), 0.0);
  EXPECT_LT(driver.step(0.01, -1e-3), 0.0);
}

// Without a dead band, some hundred noisy samples would move the reach outwards and remove all of the force.
TEST(FirstLoading, NoiseWithinTheDeadBandTakesNothing) {
  Driver driver("first_loading stiffness=1e6 yield_share=0.1 dead_band=1e-5");
  driver.step(0.01, 1e-3);
  const double force = driver.step(0.01, 0.995e-3);
  for (int i = 0; i < 1000; ++i) {
    driver.step(0.01, 0.995e-3 + (i % 2 == 0 ? 4.9e-6 : -4.9e-6));
  }
  EXPECT_EQ(driver.step(0.01, 0.995e-3), force);
  EXPECT_NEAR(force, kStiffness * 0.1 / 1.1 * 1e-3, 1e-5 * kStiffness);
}

}  // namespace
}  // namespace rubber_suspension::test
