// Laws that equal another law in a limit, at a steady rate, or within a gap.
#include "element/driver.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

/// Two components whose forces must agree under random motion.
struct Limit {
  std::string name;
  Entries law;
  Entries other;
  double dt;              // [s]
  double reach;           // largest displacement [m]
  double tolerance;       // [N]
  int samples = 0;        // samples per cycle if the motion is a sine
  bool relative = false;  // the tolerance is relative to the force
};

const double kOneHertz = 2.0 * element::kPi;  // angular frequency of 1 Hz [rad/s]
const std::string kFluid = "inertia_track inertance=1e7 resistance=2.4e8 compliance=2.5e-11 pumping_area=5e-3";

const std::vector<Limit> kLimits = {
    {"springpot_of_order_0",
     {entry("springpot stiffness=1e6 order=1e-6 low_frequency=0.01 high_frequency=100")},
     // The law differs from a spring by |x^alpha - 1|, some 1e-6 ln x, plus rounding.
     {spring(1e6)},
     0.01,
     1e-3,
     1e-5 * 1e3,
     63},
    {"springpot_of_order_1",
     {entry("springpot stiffness=1e6 order=0.999999 low_frequency=0.01 high_frequency=100")},
     {dashpot(1e6 / kOneHertz)},
     0.01,
     1e-3,
     2e-4 * 1e3,
     63},
    {"power_dashpot_of_power_1",
     {entry("power_dashpot damping=2e4 reference_rate=0.05 exponent=1")},
     {entry("dashpot damping=2e4 order=2")},
     0.01,
     1e-3,
     1e-9,
     0,
     true},
    {"position_dashpots_of_both_sides",
     {entry("position_dashpot damping=2e4 reference_displacement=1e-3 power=1 side=1"),
      entry("position_dashpot damping=2e4 reference_displacement=1e-3 power=1 side=-1")},
     {entry("dashpot damping=2e4 order=2")},
     0.01,
     0.9e-3,
     1e-9},
    {"sliding_maxwell_below_its_limit",
     {entry("sliding_maxwell stiffness=1e6 break_frequency=2 yield_displacement=1")},
     {maxwell(1e6, 2.0)},
     0.02,
     3e-3,
     0.0},
    // Moving by 10 mm changes the relaxation rate and the network by 1e-14, which is less than rounding.
    {"payne_maxwell_for_a_long_travel",
     {entry("payne_maxwell stiffness=1e6 break_frequency=2 recovery_time=0.3 travel=1e12")},
     {maxwell(1e6, 2.0)},
     0.02,
     3e-3,
     1e-8},
    {"transient_network_for_a_long_travel",
     {entry("transient_network stiffness=1e6 break_frequency=2 recovery_time=0.3 travel=1e12")},
     {maxwell(1e6, 2.0)},
     0.02,
     3e-3,
     1e-8},
    // The tolerance is 1e-9 of the largest force.
    {"nonlinear_maxwell_below_its_yield",
     {entry("nonlinear_maxwell stiffness=1e6 break_frequency=2 displacement=1e6")},
     {maxwell(1e6, 2.0)},
     0.05,
     1e-3,
     1e-6},
    {"maxwell_behind_no_play",
     {entry("maxwell_behind_play stiffness=1e6 break_frequency=2 gap=1e-15")},
     {maxwell(1e6, 2.0)},
     0.05,
     3e-3,
     1e-6},
    {"overstress_below_its_limit",
     {entry("overstress stiffness=1e6 yield_displacement=2e-4 reference_rate=0.01 power=2")},
     {spring(1e6)},
     1e3,
     1.9e-4,
     1e-9},
    {"variable_friction_without_growth_and_wear",
     {entry("variable_friction stiffness=1e6 yield_displacement=4e-4")},
     {entry("coulomb_friction maximum_force=400 stiffness=1e6")},
     0.01,
     2e-3,
     1e-9},
    // While friction slides, the force of the implicit step is less than 1e-10 below the limit.
    {"viscoplastic_friction_far_above_its_half_rate",
     {entry("viscoplastic_friction stiffness=1e6 yield_displacement=4e-4 half_rate=1e-12")},
     {entry("coulomb_friction maximum_force=400 stiffness=1e6")},
     0.01,
     2e-3,
     1e-8 * 400.0},
    // The amplitude is far below the yield displacement. The implicit method lags by half a step, 3e-3 of k z.
    {"viscoplastic_friction_of_small_force",
     {entry("viscoplastic_friction stiffness=1e6 yield_displacement=4e-4 half_rate=5e-3")},
     {maxwell(1e6, 5e-3 / 4e-4 / kOneHertz)},
     0.5 / 2000,
     1e-7,
     4e-3 * 1e6 * 1e-7,
     2000},
    {"fluid_of_an_inertia_track",
     {entry(kFluid)},
     {entry("inertia_track mass=250 damping=6e3 stiffness=1e6")},
     5e-3,
     2e-3,
     1e-9,
     0,
     true},
    {"fluid_with_quadratic_resistance",
     {entry(kFluid + " quadratic_resistance=1.6e12")},
     {entry("inertia_track mass=250 damping=6e3 stiffness=1e6 quadratic_damping=2e5")},
     5e-3,
     2e-3,
     1e-9,
     0,
     true},
    {"spring_table_of_two_points",
     {entry("spring_table displacement=-1e-3,1e-3 force=-3e3,3e3")},
     {spring(3e6)},
     0.01,
     7e-3,
     1e-9},
    {"bump_stop_without_gap", {entry("bump_stop stiffness=2e7 gap=0 exponent=1")}, {spring(2e7)}, 0.01, 1e-3, 1e-11},
    {"softening_by_nothing",
     {spring(1e6), entry("stress_softening reduction=0 width=0.2")},
     {spring(1e6)},
     0.01,
     2e-3,
     0.0},
    {"delay_of_nothing", {spring(1e6), entry("time_delay delay=0")}, {spring(1e6)}, 1e-3, 1.0, 0.0},
};

class InALimit : public testing::TestWithParam<Limit> {};
INSTANTIATE_TEST_SUITE_P(Laws, InALimit, testing::ValuesIn(kLimits), [](const auto& test) { return test.param.name; });

TEST_P(InALimit, IsTheOtherLaw) {
  const Limit& limit = GetParam();
  WithState law(limit.law);
  WithState other(limit.other);
  std::mt19937 generator(17);
  std::uniform_real_distribution<double> uniform(-limit.reach, limit.reach);
  for (int i = 1; i <= std::max(200, 2 * limit.samples); ++i) {
    const double z = limit.samples > 0 ? limit.reach * std::sin(kOneHertz * i / limit.samples) : uniform(generator);
    const double expected = other.step(limit.dt, z);
    const double tolerance = limit.tolerance * (limit.relative ? std::abs(expected) : 1.0);
    ASSERT_NEAR(law.step(limit.dt, z), expected, tolerance) << "step " << i;
  }
}

/// The force that a law reaches at a steady rate.
struct Flow {
  std::string law;
  double rate;      // [m/s]
  double duration;  // [s]
  int steps;
  double force;      // [N]
  double tolerance;  // [N]
};

std::vector<Flow> flows() {
  constexpr double kViscous = 1e6 * 0.05 / (2.0 * element::kPi * 2.0);  // force k tau v of a Maxwell element [N]
  std::vector<Flow> flows = {
      // The force F solves k tau v = F (1 + F/(k y)).
      {"nonlinear_maxwell stiffness=1e6 break_frequency=2 displacement=5e-4", 0.05, 2.0, 20000,
       500.0 * (std::sqrt(0.25 + kViscous / 500.0) - 0.5), 1e-4 * kViscous},
      // With travel s and recovery time T, the forces are k v/(1/tau + v/s), Dahl's k s, and k s/(1 + v T/s).
      {"payne_maxwell stiffness=1e6 break_frequency=2 recovery_time=0.3 travel=5e-3", 0.05, 20.0, 20000,
       1e6 * 0.05 / (2.0 * element::kPi * 2.0 + 0.05 / 5e-3), 1e-9},
      {"payne_maxwell stiffness=1e6 break_frequency=0 recovery_time=0 travel=5e-4", 0.05, 2.0, 1, 500.0, 1e-9},
      {"transient_network stiffness=1e6 break_frequency=0 recovery_time=0.3 travel=5e-3", 0.05, 10.0, 1,
       5e3 / (1.0 + 0.05 * 0.3 / 5e-3), 1e-9},
      // With travel s and build-up time T_b, wear and build-up balance at 1/(1 + v T_b/s) of the full limit.
      {"variable_friction stiffness=1e6 yield_displacement=4e-4 travel=2e-3 build_up_time=0.5", 0.01, 20.0, 1,
       400.0 / (1.0 + 0.01 * 0.5 / 2e-3), 1e-9},
      // The force is c v + c_2 v^2. Steps of 1 ms have an error of 1e-4 of c_2 v^2 (see inertia_track_test.cpp).
      {"inertia_track mass=250 damping=6e3 stiffness=1e6 quadratic_damping=2e5", 0.05, 1.0, 1000,
       6e3 * 0.05 + 2e5 * 0.05 * 0.05, 0.5}};
  // The fluid moves at the speed v, with the damping force c v. Damping is critical for 9 kg, c^2/(4 k).
  for (const double mass : {250.0, 9.0, 0.5}) {
    flows.push_back(
        {fmt::format("inertia_track mass={} damping=6e3 stiffness=1e6", mass), 0.01, 100.0, 1, 60.0, 1e-9 * 6e3});
  }
  // The force is k y (v/v_r)^p up to rounding, because a step uses the flow at its end.
  for (const double exponent : {0.5, 0.8, 1.0, 1.7, 2.0}) {
    for (const double rate : {0.025, 0.05, 0.1}) {
      flows.push_back({fmt::format("power_dashpot_behind_play stiffness=1e6 displacement=1e-4 reference_rate=0.05 "
                                   "exponent={} gap=1e-3",
                                   exponent),
                       rate, 2.0, 2000, 100.0 * std::pow(rate / 0.05, exponent), 1e-6});
    }
  }
  for (const double power : {1.0, 2.0, 3.5}) {
    for (const double rate : {1e-3, 0.01, 0.3}) {
      const double force = 200.0 * (1.0 + std::pow(rate / 0.01, 1.0 / power));
      flows.push_back(
          {fmt::format("overstress stiffness=1e6 yield_displacement=2e-4 reference_rate=0.01 power={}", power), rate,
           10.0, 4000, force, 1e-4 * force});
    }
  }
  // At the half rate, the force is half of the limit. The transient decays to 1e-11 with y/v_0 = 80 ms or faster.
  for (const double share : {-9.0, -1.0, -0.1, 0.1, 1.0, 9.0}) {
    flows.push_back({"viscoplastic_friction stiffness=1e6 yield_displacement=4e-4 half_rate=5e-3", 5e-3 * share, 2.0,
                     2000, 400.0 * share / (1.0 + std::abs(share)), 1e-8 * 400.0});
  }
  return flows;
}

TEST(AtASteadyRate, ForcesAreThoseOfTheirFormulas) {
  for (const Flow& flow : flows()) {
    Driver driver(flow.law);
    driver.walk(flow.duration, flow.duration * flow.rate, flow.steps);
    EXPECT_NEAR(driver.output(), flow.force, flow.tolerance) << flow.law << " at " << flow.rate << " m/s";
  }
}

TEST(WithinItsGap, ALawGivesNothing) {
  for (const char* law : {"friction_behind_play stiffness=1e6 yield_displacement=4e-4 gap=1e-3",
                          "maxwell_behind_play stiffness=1e6 break_frequency=2 gap=1e-3",
                          "power_dashpot_behind_play stiffness=1e6 displacement=1e-4 reference_rate=0.05 exponent=2 "
                          "gap=1e-3",
                          "bump_stop stiffness=2e7 gap=1e-3", "free_play gap=1e-3",
                          "inertia_track mass=250 damping=6e3 stiffness=1e6 free_travel=1e-3"}) {
    Driver driver(law);
    for (const double z : {5e-4, -9.99e-4, 9.99e-4, 0.0, 1e-3}) {
      EXPECT_EQ(driver.step(0.01, z), 0.0) << law << ' ' << z;
    }
  }
}

}  // namespace
}  // namespace rubber_suspension::test
