// A component: sums, the order of effects on the displacement, series compliance, delay and parts compared with closed
// forms. Also its state, trial steps and tangent.
#include "rubber_suspension/component/component.h"

#include "element/driver.h"
#include "element/typical_elements.h"
#include "rubber_suspension/element/maxwell.h"
#include "support/allocation_counter.h"
#include "support/kit.h"

namespace rubber_suspension::test {
namespace {

const element::ElementDescription kSpring = spring(3e6);
const element::ElementDescription kDashpot = dashpot(1e4);
const element::ElementDescription kMaxwell = maxwell(1.3e6, 1.43);
const element::ElementDescription kFastMaxwell = maxwell(6e5, 15.0);
const element::ElementDescription kFriction = friction(5e3, 1e-3);
const element::ElementDescription kSeriesCompliance = entry("series_compliance stiffness=3e7");

element::ElementDescription compliance(double stiffness, double side = 0.0) {
  return entry("series_compliance", {{"stiffness", stiffness}, {"side", side}});
}

double sineAt(int i, int samples, double amplitude) {
  return amplitude * std::sin(2.0 * element::kPi * (i % samples) / samples);
}

std::vector<double> walk(const component::Component& component, component::ComponentState& state, unsigned seed,
                         int steps) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<double> forces;
  for (int i = 0; i < steps; ++i) {
    const double dt = 1e-3 * std::exp(uniform(generator));
    forces.push_back(component.step(state, dt, 2e-3 * uniform(generator)).total);
  }
  return forces;
}

TEST(Component, ComplexStiffnessIsTheSumOfThoseOfItsElements) {
  const component::Component component({kSpring, kDashpot, kMaxwell});
  const double omega = 2.0 * element::kPi * 4.0;
  const std::complex<double> iwt(0.0, omega / (2.0 * element::kPi * 1.43));
  const std::complex<double> expected = 3e6 + std::complex<double>(0.0, 1e4 * omega) + 1.3e6 * iwt / (1.0 + iwt);
  EXPECT_TRUE(component.linear());
  EXPECT_LE(std::abs(*component.complexStiffness(4.0) / expected - 1.0), 1e-15);
}

TEST(Component, MeetsThePapersExample) {
  // Polach's example of a spring and one Maxwell element has 4.2 kN/mm and 5.76 degrees at 4 Hz.
  const component::Component component({kSpring, maxwell(1.3295e6, 1.43)});
  const std::complex<double> k = *component.complexStiffness(4.0);
  EXPECT_NEAR(std::abs(k), 4.2e6, 1e3);
  EXPECT_NEAR(std::arg(k) * 180.0 / element::kPi, 5.76, 0.01);
}

TEST(Component, NonlinearElementsHaveNoComplexStiffness) {
  for (const element::ElementDescription& law :
       {kFriction, entry("bump_stop stiffness=1e6 gap=0"), entry("free_play gap=1e-4"),
        entry("stress_softening reduction=0.1")}) {
    const component::Component component({kSpring, law});
    EXPECT_FALSE(component.linear()) << law.type;
    EXPECT_FALSE(component.complexStiffness(1.0).has_value()) << law.type;
  }
}

TEST(Component, OrderOfElementsIsWithoutInfluenceButForRounding) {
  WithState one({kSpring, kMaxwell, kFriction, kFastMaxwell, kDashpot});
  WithState other({kDashpot, kFastMaxwell, kFriction, kMaxwell, kSpring});
  const std::vector<double> forces = walk(one, one.state, 1, 100);
  const std::vector<double> others = walk(other, other.state, 1, 100);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    EXPECT_NEAR(forces[i], others[i], 1e-12 * 1e5);
  }
}

/// A component with one element of each type, which uses all entries of the state's memory.
class Everything : public testing::Test {
 protected:
  component::Component component_{typicalElements()};
  component::ComponentState state_ = component_.makeState();
};

TEST_F(Everything, HasPartsThatAddUpToTheTotal) {
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> uniform(-2e-3, 2e-3);
  for (int i = 0; i < 300; ++i) {
    const element::ComponentForce force = component_.step(state_, 1e-3, uniform(generator));
    const double largest = std::abs(force.elastic) + std::abs(force.viscous) + std::abs(force.friction);
    ASSERT_NEAR(force.total, force.elastic + force.viscous + force.friction, 1e-14 * largest);
  }
}

TEST_F(Everything, IsLeftAsItWasByTrialStepsAndTangents) {
  walk(component_, state_, 3, 50);
  const std::vector<double> memory = state_.memory();
  component::ComponentState trial = state_;
  const double tried = component_.step(trial, 1e-3, 1e-3).total;
  component_.tangent(state_, 1e-3, 1e-3, trial);
  EXPECT_EQ(state_.memory(), memory);
  EXPECT_EQ(component_.step(state_, 1e-3, 1e-3).total, tried);
}

TEST_F(Everything, ContinuesFromSavedNumbersBitByBit) {
  walk(component_, state_, 4, 77);
  component::ComponentState other = component::Component(component_.elements()).makeState();
  component_.restore(other, state_.displacement(), state_.memory());
  const std::vector<double> forces = walk(component_, state_, 5, 100);
  EXPECT_EQ(walk(component_, other, 5, 100), forces);
}

TEST_F(Everything, ServesSeveralThreadsAtOnce) {
  std::vector<std::vector<double>> forces(3);
  std::vector<std::thread> threads;
  threads.reserve(forces.size());
  for (std::vector<double>& result : forces) {
    threads.emplace_back([this, &result] {
      component::ComponentState state = component_.makeState();
      result = walk(component_, state, 6, 2000);
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(forces[1], forces[0]);
  EXPECT_EQ(forces[2], forces[0]);
}

TEST_F(Everything, AllocatesNothing) {
  component::ComponentState trial = component_.makeState();
  const AllocationCounter counter;
  for (int i = 0; i < 100; ++i) {
    component_.step(state_, 1e-3 * (1 + i % 3), sineAt(i, 30, 2e-3));
  }
  component_.tangent(state_, 1e-3, 1e-3, trial);
  component_.initialise(state_, 0.0);
  EXPECT_EQ(counter.count(), 0U);
}

TEST(Component, PartsGoWhereTheyBelong) {
  WithState component({kSpring, kMaxwell, kFriction});
  const element::ComponentForce force = component.Component::step(component.state, 1e-9, 1e-3);
  EXPECT_DOUBLE_EQ(force.elastic, 3e3);
  EXPECT_NEAR(force.viscous, 1.3e3, 1e-4);
  EXPECT_DOUBLE_EQ(force.friction, 2.5e3);
}

TEST(Component, WithoutElementsIsWithoutForce) {
  WithState component(Entries{});
  EXPECT_EQ(component.step(1e-3, 1.0), 0.0);
  EXPECT_EQ(*component.complexStiffness(1.0), 0.0);
}

// A spring K and a compliance K_s in series have the stiffness 1/(1/K + 1/K_s), up to the tolerance of the solver.
// Several compliances add up. One-sided compliances add up on their side only.
TEST(SeriesCompliance, OfASpringIsASpringInSeries) {
  const struct {
    Entries compliances;
    double tension;      // [m/N]
    double compression;  // [m/N]
  } rows[] = {{{kSeriesCompliance}, 1.0 / 3e7, 1.0 / 3e7},
              {{kSeriesCompliance, compliance(6e6)}, 1.0 / 3e7 + 1.0 / 6e6, 1.0 / 3e7 + 1.0 / 6e6},
              {{compliance(6e6, 1.0), kSeriesCompliance}, 1.0 / 3e7 + 1.0 / 6e6, 1.0 / 3e7},
              {{compliance(6e6, 1.0), compliance(6e6, -1.0)}, 1.0 / 6e6, 1.0 / 6e6}};
  for (const auto& row : rows) {
    WithState component(Entries{kSpring} + row.compliances);
    for (const double z : {1e-3, -2e-3, 1e-9, 0.0, 0.5}) {
      const double force = z / (1.0 / 3e6 + (z > 0.0 ? row.tension : row.compression));
      EXPECT_NEAR(component.step(1e-3, z), force, 1e-12 * std::abs(force)) << row.tension << ' ' << z;
      EXPECT_NEAR(component.initialise(z), force, 1e-12 * std::abs(force)) << row.tension << ' ' << z;
    }
    EXPECT_EQ(component.complexStiffness(1.0).has_value(), row.tension == row.compression);
  }
}

// The stiffness of a spring k0 and a Maxwell element M in series with a compliance is K_s (k0 + M)/(K_s + k0 + M). A
// step assumes that the displacement of the specimen is linear.
TEST(SeriesCompliance, TendsToTheClosedFormWithTheStep) {
  const component::Component component({kSpring, kMaxwell, kSeriesCompliance});
  const std::complex<double> specimen = *component::Component({kSpring, kMaxwell}).complexStiffness(4.0);
  const std::complex<double> expected = specimen / (1.0 + specimen / 3e7);
  EXPECT_LE(std::abs(*component.complexStiffness(4.0) / expected - 1.0), 1e-14);
  const double coarse = std::abs(settledStiffness(component, 4.0, 50, 20) - expected);
  const double fine = std::abs(settledStiffness(component, 4.0, 200, 20) - expected);
  EXPECT_LE(fine, coarse / 12.0) << "second order: 1/16";
  EXPECT_LE(fine, 1e-3 * std::abs(expected));
}

// A specimen without the compliance has the same force at its share of the displacement. An idle stop makes the
// component use the general solver instead of the one for springs, Maxwell elements and friction.
TEST(SeriesCompliance, ForceBalanceHoldsWithFriction) {
  const element::ElementDescription opens = entry("series_compliance stiffness=8e6 side=1");
  const element::ElementDescription closes = entry("series_compliance stiffness=5e6 closing_force=2e3");
  const element::ElementDescription idle = entry("bump_stop stiffness=1e6 gap=1");
  const auto opening = [](double force) { return std::max(force, 0.0) / 8e6 + force / 3e7; };
  const auto closing = [](double force) { return force / (5e6 * (1.0 + std::abs(force) / 2e3)); };
  const auto both = [&](double force) { return std::max(force, 0.0) / 8e6 + closing(force); };
  const std::vector<std::pair<Entries, std::function<double(double)>>> cases = {
      {{kSeriesCompliance}, [](double force) { return force / 3e7; }},
      {{opens, kSeriesCompliance}, opening},
      {{opens, closes}, both},
      {{opens, kSeriesCompliance, idle}, opening},
      {{closes, idle}, closing}};
  for (const auto& [compliance, deflection] : cases) {
    const Entries laws = {kSpring, kMaxwell, kFriction};
    WithState bare(laws);
    WithState compliant(laws + compliance);
    for (int i = 1; i <= 400; ++i) {
      const double z = sineAt(i, 100, 2e-3);
      const double force = compliant.step(1e-3, z);
      ASSERT_NEAR(bare.step(1e-3, z - deflection(force)), force, 1e-8 * 1e4) << i;
    }
  }
}

// The equations F = K z' and z' = z - F/(K_s (1 + |F|/F_c)) give a quadratic equation in F.
TEST(SeriesCompliance, ThatClosesUnderLoadMeetsTheClosedForm) {
  constexpr double kStiffness = 4e6;
  constexpr double kClosing = 800.0;
  WithState component({kSpring, {"series_compliance", {{"stiffness", {kStiffness}}, {"closing_force", {kClosing}}}}});
  for (const double z : {1e-3, -2e-3, 1e-6, 0.05, -1e-9}) {
    // |F|^2/(K F_c) + |F| (1/K + 1/K_s - |z|/F_c) - |z| = 0
    const double square = 1.0 / (3e6 * kClosing);
    const double half = 0.5 * (1.0 / 3e6 + 1.0 / kStiffness - std::abs(z) / kClosing);
    const double force = std::copysign(std::abs(z) / (half + std::sqrt(half * half + square * std::abs(z))), z);
    EXPECT_NEAR(component.step(1e-3, z) / force, 1.0, 1e-11) << z;
    EXPECT_NEAR(component.initialise(z) / force, 1.0, 1e-11) << z;
  }
  EXPECT_FALSE(component.linear());
}

const element::ElementDescription kStrap = entry("lift_off side=1");

TEST(LiftOff, CarriesOneSignOfForce) {
  WithState strap({kSpring, kStrap});
  WithState chevron({kSpring, kSeriesCompliance, entry("lift_off side=-1")});
  const double in_series = 1.0 / (1.0 / 3e6 + 1.0 / 3e7);
  constexpr double kRounding = 1e-9;  // rounding of forces of some kN [N]
  for (const double z : {1e-3, -1e-3, 2e-3, -5e-3, 1e-6}) {
    EXPECT_NEAR(strap.step(1e-3, z), std::max(0.0, 3e6 * z), kRounding) << z;
    EXPECT_NEAR(chevron.step(1e-3, z), std::min(0.0, in_series * z), kRounding) << z;
    EXPECT_NEAR(strap.initialise(z), std::max(0.0, 3e6 * z), kRounding) << z;
    EXPECT_NEAR(chevron.initialise(z), std::min(0.0, in_series * z), kRounding) << z;
  }
  EXPECT_FALSE(strap.linear());
}

TEST(LiftOff, BeyondItsPreloadIsOpenOrHeld) {
  constexpr double kRounding = 1e-9;  // rounding of forces of some kN [N]
  for (const double side : {1.0, -1.0}) {
    const element::ElementDescription contact{"lift_off", {{"side", {side}}, {"preload", {600.0}}}};
    element::ElementDescription bolted = contact;
    bolted.values["slack_stiffness"] = {1e6};
    WithState open({kSpring, contact});
    WithState held({kSpring, bolted});
    for (const double z : {1e-3, -1.9e-4, -1e-3, 2e-3, -5e-3}) {
      const double beyond = (z + 2e-4) / (1.0 / 3e6 + 1.0 / 1e6);  // the excess displacement is in specimen and holder
      EXPECT_NEAR(side * open.step(1e-3, side * z), std::max(-600.0, 3e6 * z), kRounding) << z;
      EXPECT_NEAR(side * held.step(1e-3, side * z), z > -2e-4 ? 3e6 * z : -600.0 + beyond, kRounding) << z;
      EXPECT_NEAR(side * open.initialise(side * z), std::max(-600.0, 3e6 * z), kRounding) << z;
    }
    EXPECT_FALSE(open.linear() || held.linear());
  }
}

// Displacement and force are measured from the state of a test piece that was preloaded long ago.
TEST(LiftOff, WithAPreloadIsOneWithoutAboutAnotherZero) {
  constexpr double kPreload = 1500.0;
  const double preloaded = kPreload / kSpring.value("stiffness");
  const component::Component strap({kSpring, kMaxwell, kStrap});
  component::ComponentState state = strap.makeState();
  ASSERT_NEAR(strap.relax(state, preloaded).total, kPreload, 1e-9);
  WithState from_there({kSpring, kMaxwell, entry("lift_off side=1 preload=1500")});
  int open = 0;
  for (int i = 1; i <= 400; ++i) {
    const double z = sineAt(i, 100, 2e-3);
    const double force = from_there.step(1e-3, z);
    ASSERT_NEAR(force, strap.step(state, 1e-3, preloaded + z).total - kPreload, 1e-8) << i;
    open += force < 1e-8 - kPreload ? 1 : 0;
  }
  EXPECT_GT(open, 100);
}

// The strap is released after its Maxwell element has relaxed. It is too long by z_0 k_m/(k + k_m), and recovers at the
// rate k/(tau (k + k_m)). The contact closes at the length that the strap has by then.
TEST(LiftOff, RecoversWhileSlack) {
  constexpr double kHeld = 1e-3;
  constexpr double kSlack = 0.05;  // [s]
  const component::Component strap({kSpring, kMaxwell, kStrap});
  const double spring = kSpring.value("stiffness");
  const double maxwell = kMaxwell.value("stiffness");
  const double rate = 2.0 * element::kPi * kMaxwell.value("break_frequency");
  component::ComponentState state = strap.makeState();
  strap.step(state, 1.0, kHeld);
  strap.step(state, 100.0, kHeld);
  const double share = maxwell / (spring + maxwell);
  constexpr double kQuick = 1e-9;  // [s]
  constexpr int kSteps = 1000;
  EXPECT_NEAR(strap.step(state, kQuick, 0.0).total, 0.0, 1e-9);
  for (int i = 0; i < kSteps; ++i) {
    EXPECT_NEAR(strap.step(state, kSlack / kSteps, -1e-4).total, 0.0, 1e-9);
  }
  const double length = kHeld * share * std::exp(-kSlack * rate * (1.0 - share));
  component::ComponentState below = state;
  EXPECT_NEAR(strap.step(below, kQuick, 0.99 * length).total, 0.0, 1e-9);
  const double closed = 0.01 * length * (spring + maxwell);
  EXPECT_NEAR(strap.step(state, kQuick, 1.01 * length).total, closed, 0.02 * closed);  // error of the finite steps
}

// While the contact is closed, it changes no bit of the force, whatever elements the test piece has.
TEST(LiftOff, ChangesNothingWhileClosed) {
  const element::ElementDescription softening = entry("stress_softening reduction=0.3");
  Entries laws = {kSpring, kMaxwell, kFriction, softening};
  WithState glued(laws);
  laws.push_back(kStrap);
  WithState strap(laws);
  int open = 0;
  for (int i = 1; i <= 400; ++i) {
    const double z = 6e-3 + sineAt(i, 100, 2e-3);
    const double force = glued.step(1e-3, z);
    ASSERT_GT(force, 0.0);
    ASSERT_EQ(strap.step(1e-3, z), force) << i;
  }
  for (int i = 1; i <= 400; ++i) {
    const double force = strap.step(1e-3, sineAt(i, 100, 2e-3));
    ASSERT_GE(force, -1e-8) << i;
    open += force < 1e-8 ? 1 : 0;
  }
  EXPECT_GT(open, 200) << "half of the motion, and what friction and relaxation leave of the length";
}

// The test piece is on a bracket, with elements that store and dissipate energy. Over random loops into the slack and
// back, the work on it is not negative. In a step, the trapezoidal rule is off by at most the change of the force.
TEST(LiftOff, WithBranchesNeverGivesMoreEnergyThanItGot) {
  constexpr int kParts = 200;
  constexpr double kRounding = 1e-9;  // rounding of the root where the contact is open [N]
  for (const auto& [side, preload] : {std::pair(1.0, 0.0), std::pair(-1.0, 0.0), std::pair(1.0, 2e3)}) {
    const component::Component held({kSpring,
                                     kMaxwell,
                                     kFastMaxwell,
                                     kFriction,
                                     kSeriesCompliance,
                                     {"lift_off", {{"side", {side}}, {"preload", {preload}}}}});
    component::ComponentState state = held.makeState();
    std::mt19937 generator(side > 0.0 ? 1 : 2);
    std::uniform_real_distribution<double> place(-4e-3, 4e-3);
    std::uniform_real_distribution<double> decades(-3.0, 0.5);
    double work = 0.0;
    double uncertainty = 0.0;
    double before = held.initialise(state, 0.0).total;
    int open = 0;
    int closed = 0;
    const AllocationCounter counter;
    for (int move = 0; move < 60; ++move) {
      const double start = state.displacement();
      const double end = move % 3 == 2 ? 0.0 : place(generator);
      const double dt = std::pow(10.0, decades(generator)) / kParts;
      for (int part = 1; part <= kParts; ++part) {
        const double z = start + (end - start) * part / kParts;
        const double increment = z - state.displacement();
        const double force = held.step(state, dt, z).total;
        ASSERT_GE(side * force, -preload - kRounding) << "move " << move;
        work += 0.5 * (before + force) * increment;
        uncertainty += (0.5 * std::abs(force - before) + kRounding) * std::abs(increment);
        ASSERT_GE(work, -uncertainty) << "move " << move;
        ++(side * force < 1.0 - preload ? open : closed);
        before = force;
      }
    }
    EXPECT_EQ(counter.count(), 0U);
    EXPECT_GT(std::min(open, closed), 2000) << "of 12000 steps";
    EXPECT_GT(work, uncertainty) << "friction and relaxation lose energy";
  }
}

// An idle stop adds no force, but makes the component use the general solver instead of a closed form.
TEST(SeriesCompliance, IsSolvedAlikeWithAndWithoutOtherElements) {
  const element::ElementDescription idle = entry("bump_stop stiffness=1e6 gap=1");
  for (unsigned trial = 0; trial < 60; ++trial) {
    std::mt19937 random(trial);
    const auto between = [&](double low, double high) {
      return low * std::pow(high / low, std::uniform_real_distribution<double>(0.0, 1.0)(random));
    };
    Entries laws{kSpring, kDashpot, compliance(between(1e5, 1e9))};
    if (trial % 3 == 1) {
      laws.push_back(compliance(between(1e5, 1e9), trial % 2 == 0 ? 1.0 : -1.0));
    }
    for (unsigned i = 0; i < trial % 4; ++i) {
      laws.push_back(maxwell(between(1e5, 1e7), between(0.01, 1e3)));
    }
    for (unsigned i = 0; i < trial / 4 % 3; ++i) {
      laws.push_back(friction(between(1.0, 1e5), between(1e-6, 1e-2)));
    }
    WithState closed(laws);
    WithState searched(laws + Entries{idle});
    const auto expected = walk(searched, searched.state, trial, 300);
    const auto forces = walk(closed, closed.state, trial, 300);
    double largest = 0.0;
    for (const double force : expected) {
      largest = std::max(largest, std::abs(force));
    }
    for (std::size_t i = 0; i < forces.size(); ++i) {
      // The dashpot multiplies the rounding of a displacement of 2 mm by up to 3e7 N/m.
      ASSERT_NEAR(forces[i], expected[i], 1e-11 * largest) << "trial " << trial << ", step " << i;
    }
  }
}

TEST(SeriesCompliance, SolvesWhereTheSpecimenSoftens) {
  // The tangent stiffness of the specimen, 3e6 + 2e9 z, falls to -1e6 at z = -2 mm. With a compliance of 1/3e7 this is
  // still stable.
  WithState component({kSpring, kSeriesCompliance, entry("asymmetric_stiffness quadratic=1e9")});
  for (int i = 1; i <= 100; ++i) {
    const double z = -2e-3 * i / 100;
    const double force = component.step(1e-3, z);
    const double specimen = z - force / 3e7;
    EXPECT_NEAR(force, 3e6 * specimen + 1e9 * specimen * specimen, 1e-7) << i;
  }
}

/// Returns the elements of a displacement path in every order.
std::vector<Entries> inEachOrder(Entries path) {
  const auto byType = [](const element::ElementDescription& one, const element::ElementDescription& other) {
    return one.type < other.type;
  };
  std::vector<Entries> orders;
  std::sort(path.begin(), path.end(), byType);
  do {
    orders.push_back(path);
  } while (std::next_permutation(path.begin(), path.end(), byType));
  return orders;
}

// Friction and relaxation have a force within the gap, and samples lie on both sides of its edge. So other orders give
// other forces, as the last two expectations check.
TEST(DisplacementPath, IsDelayThenFreePlayThenSeriesCompliance) {
  constexpr double kStep = 1e-3;  // [s]
  const element::ElementDescription delay = entry("time_delay delay=0.4e-3");
  const element::ElementDescription play = entry("free_play gap=3e-4 share=0.8");
  const auto behind = [&](double displacement) { return Driver(play, displacement).output(); };
  for (const auto& path : inEachOrder({delay, play, kSeriesCompliance})) {
    Entries entries = {kSpring, kMaxwell, kFriction};
    entries.insert(entries.begin() + 1, path.begin(), path.end());
    WithState component(entries);
    WithState behind_play({kSpring, kMaxwell, kFriction, kSeriesCompliance});
    Driver delayed(delay);
    double of_play_first = 0.0;        // largest difference of the displacement [m]
    double of_compliance_first = 0.0;  // largest difference of the displacement [m]
    for (int i = 1; i <= 200; ++i) {
      const double z = sineAt(i, 50, 1e-3);
      const double before = sineAt(i - 1, 50, 1e-3);
      const double late = delayed.step(kStep, z);
      const double force = component.step(kStep, z);
      ASSERT_EQ(force, behind_play.step(kStep, behind(late))) << "sample " << i;
      const double yielded = force / 3e7;
      const double share = (late - before) / (z - before);
      const double delayed_after_play = behind(before) + share * (behind(z) - behind(before));
      of_play_first = std::max(of_play_first, std::abs(delayed_after_play - behind(late)));
      of_compliance_first = std::max(of_compliance_first, std::abs(behind(late - yielded) - (behind(late) - yielded)));
    }
    EXPECT_GT(of_play_first, 1e-6) << "[m]";
    EXPECT_GT(of_compliance_first, 1e-6) << "[m]";
  }
}

TEST(Delay, ShiftsTheForceOfASpring) {
  constexpr double kDelay = 3.25e-3;
  WithState component({kSpring, {"time_delay", {{"delay", {kDelay}}}}});
  const auto motion = [](double t) { return t < 0.0 ? 0.0 : 0.2 * t; };
  for (int i = 1; i <= 100; ++i) {
    EXPECT_NEAR(component.step(1e-3, motion(1e-3 * i)), 3e6 * motion(1e-3 * i - kDelay), 1e-7) << i;
  }
  const std::complex<double> k = *component.complexStiffness(10.0);
  EXPECT_NEAR(std::arg(k), -2.0 * element::kPi * 10.0 * kDelay, 1e-12);
  EXPECT_NEAR(std::abs(k), 3e6, 1e-6);
}

TEST(Delay, IsExactWhereItIsAWholeNumberOfSamples) {
  WithState delayed({kSpring, kMaxwell, entry("time_delay", {{"delay", 4.0 / 1024.0}})});
  WithState direct({kSpring, kMaxwell});
  std::vector<double> forces = {0.0, 0.0, 0.0, 0.0};
  for (int i = 1; i <= 200; ++i) {
    forces.push_back(direct.step(1.0 / 1024.0, sineAt(i, 77, 1e-3)));
    EXPECT_NEAR(delayed.step(1.0 / 1024.0, sineAt(i, 77, 1e-3)), forces[static_cast<std::size_t>(i) - 1], 1e-9);
  }
}

TEST(Rig, SeesTheActuatorAndNotTheSpecimen) {
  const element::ElementDescription inertia = entry("inertia mass=10");
  const element::ElementDescription offset = entry("force_offset offset=100");
  WithState component({kSpring, kSeriesCompliance, inertia, offset, entry("stress_softening reduction=0.9")});
  const std::complex<double> specimen = 3e6 / (1.0 + 0.1);
  const double omega = 2.0 * element::kPi * 20.0;
  const component::Component linear({kSpring, kSeriesCompliance, inertia, offset});
  EXPECT_NEAR(std::abs(*linear.complexStiffness(20.0) - (specimen - 10.0 * omega * omega)), 0.0, 1e-6);
  EXPECT_EQ(component.initialise(0.0), 100.0) << "softening leaves the offset";
}

TEST(Relax, KeepsSofteningAndForgetsTheRest) {
  WithState component({kSpring, kMaxwell, kSeriesCompliance, entry("stress_softening reduction=0.3")});
  const double first = component.step(1.0, 1e-3);
  component.step(1.0, 3e-3);
  EXPECT_EQ(component.relax(0.0), 0.0);
  const double second = component.step(1.0, 1e-3);
  EXPECT_LT(second, 0.8 * first);
  const double held = component.relax(1e-3);
  EXPECT_LT(held, second) << "relaxed at once";
  EXPECT_NEAR(component.step(1e6, 1e-3), held, 1e-9 * held) << "and stays so";
  component.initialise(0.0);
  EXPECT_EQ(component.step(1.0, 1e-3), first) << "a new specimen";
}

TEST(State, RefusesNumbersThatAreNotItsOwn) {
  const component::Component component({kSpring, kMaxwell});
  component::ComponentState state = component.makeState();
  EXPECT_THROW(component.restore(state, 0.0, {}), std::invalid_argument);
  EXPECT_THROW(component.restore(state, 0.0, {1.0, 2.0}), std::invalid_argument);
  EXPECT_THROW(component.restore(state, NAN, {1.0}), std::invalid_argument);
  EXPECT_THROW(component.restore(state, 0.0, {INFINITY}), std::invalid_argument);
  EXPECT_NO_THROW(component.restore(state, 0.0, {1.0}));
}

TEST(State, RefusesPlacesAndCountsThatNoDelayHasLeft) {
  const component::Component component({kSpring, entry("time_delay delay=0.01")});
  component::ComponentState state = component.makeState();
  const std::vector<double> own = state.memory();
  const auto refused = [&](std::size_t slot, double number) {
    std::vector<double> memory = own;
    memory[slot] = number;
    EXPECT_THROW(component.restore(state, 0.0, memory), std::invalid_argument) << slot << ": " << number;
  };
  constexpr std::size_t kNewest = 1;
  constexpr std::size_t kCount = 2;
  for (const double number : {-1.0, 0.5, 256.0, 2e9, -2e9, 1e300}) {
    refused(kNewest, number);
  }
  for (const double number : {-1.0, 0.0, 1.5, 257.0, 2e9}) {
    refused(kCount, number);
  }
  component.restore(state, 0.0, own);
}

TEST(Component, ChangingStepLengthsGiveWhatEachWouldGive) {
  const component::Component component({kSpring, kDashpot, kMaxwell, kFastMaxwell});
  component::ComponentState state = component.makeState();
  walk(component, state, 7, 20);
  component::ComponentState fresh = component.makeState();  // no coefficients prepared for another time step
  component.restore(fresh, state.displacement(), state.memory());
  component.step(state, 0.5, 1e-3);
  component.step(fresh, 0.5, 1e-3);
  EXPECT_EQ(component.step(state, 1e-3, 2e-3).total, component.step(fresh, 1e-3, 2e-3).total);
}

TEST(Component, SaysWhichEntryIsWrong) {
  EXPECT_NE(messageOf<std::invalid_argument>([&] {
              component::Component component({kSpring, maxwell(1.0, -2.0)});
            }).find("maxwell.break_frequency: -2"),
            std::string::npos);
}

TEST(Component, GivesItsEntriesWithDefaults) {
  const component::Component component({kFriction});
  EXPECT_EQ(component.elements().at(0).value("dead_band"), 0.0);
}

TEST(Tangent, OfLinearElementsInClosedForm) {
  constexpr double kDt = 2e-3;
  const component::Component component({kSpring, kDashpot, kMaxwell});
  component::ComponentState state = component.makeState();
  component::ComponentState trial = component.makeState();
  walk(component, state, 8, 20);
  const element::MaxwellStep step(1.3e6, element::Relaxation::over(kDt * 2.0 * element::kPi * 1.43));
  const component::Tangent tangent = component.tangent(state, kDt, 1e-3, trial);
  // The tolerance is the rounding error of 1e-16 of some kN, divided by the difference of 2e-8 m.
  EXPECT_NEAR(tangent.stiffness, 3e6, 1e-8 * 3e6);
  EXPECT_NEAR(tangent.damping, 1e4 + kDt * step.gain, 1e-8 * 1e4);
}

TEST(Tangent, OfFrictionAndSeriesComplianceInClosedForm) {
  const component::Component component({kSpring, kFriction, kSeriesCompliance});
  component::ComponentState state = component.makeState();
  component::ComponentState trial = component.makeState();
  const component::Tangent tangent = component.tangent(state, 1e-3, 0.5e-3, trial);
  component::ComponentState moved = state;
  const double specimen = 0.5e-3 - component.step(moved, 1e-3, 0.5e-3).total / 3e7;
  const double stiffness = 3e6 + 5e3 * 1e-3 / std::pow(1e-3 + specimen, 2);  // derivative of k z + F_max z/(z2 + z)
  EXPECT_NEAR(tangent.stiffness, stiffness / (1.0 + stiffness / 3e7), 1e-6 * stiffness);
  EXPECT_EQ(tangent.damping, 0.0);
}

// Simulates a mass on the component with an implicit integrator: trapezoidal rule and Newton's method.
double displacementOfMass(const component::Component& component, double dt, double duration) {
  constexpr double kMass = 5000.0;
  constexpr double kLoad = 4000.0;
  constexpr double kTolerance = 1e-5;  // [N]; in the finest step, 4 m z/dt^2 has a rounding error of 1e-6
  component::ComponentState state = component.makeState();
  component::ComponentState trial = component.makeState();
  double z = 0.0;
  double velocity = 0.0;
  double acceleration = kLoad / kMass;
  for (int i = 0; i < std::lround(duration / dt); ++i) {
    double next = z + dt * velocity;
    double residual = 1.0;
    for (int iteration = 0; iteration < 6 && std::abs(residual) > kTolerance; ++iteration) {
      const double next_acceleration = 4.0 / (dt * dt) * (next - z - dt * velocity) - acceleration;
      trial = state;
      residual = kMass * next_acceleration + component.step(trial, dt, next).total - kLoad;
      const component::Tangent tangent = component.tangent(state, dt, next, trial);
      next -= residual / (4.0 * kMass / (dt * dt) + tangent.stiffness + tangent.damping / dt);
    }
    EXPECT_LE(std::abs(residual), kTolerance) << "Newton's method must converge quadratically";
    const double next_acceleration = 4.0 / (dt * dt) * (next - z - dt * velocity) - acceleration;
    velocity += 0.5 * dt * (acceleration + next_acceleration);
    acceleration = next_acceleration;
    z = next;
    component.step(state, dt, z);
  }
  return z;
}

TEST(Tangent, LetsAnImplicitIntegratorConverge) {
  const component::Component component({kSpring, kMaxwell, kFriction, kSeriesCompliance});
  const double reference = displacementOfMass(component, 1e-3 / 16, 0.2);
  const double coarse = std::abs(displacementOfMass(component, 4e-3, 0.2) - reference);
  const double fine = std::abs(displacementOfMass(component, 1e-3, 0.2) - reference);
  EXPECT_LE(fine, 1e-2 * std::abs(reference));
  EXPECT_LE(fine, 0.4 * coarse);
}

}  // namespace
}  // namespace rubber_suspension::test
