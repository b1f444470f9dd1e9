// Many components side by side against each one alone: the same bits.
#include "rubber_suspension/component/fleet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "support/allocation_counter.h"

namespace rubber_suspension::test {
namespace {

using testing::HasSubstr;

element::ElementDescription spring(double stiffness) { return {"spring", {{"stiffness", {stiffness}}}}; }

element::ElementDescription maxwell(double stiffness, double break_frequency) {
  return {"maxwell", {{"stiffness", {stiffness}}, {"break_frequency", {break_frequency}}}};
}

element::ElementDescription friction(double maximum_force, double displacement, double dead_band) {
  return {"friction",
          {{"maximum_force", {maximum_force}}, {"displacement", {displacement}}, {"dead_band", {dead_band}}}};
}

/// Components of one build whose parameters are drawn each for itself.
std::vector<component::Component> randomFleet(std::mt19937& random, std::size_t size, int maxwells, bool frictional) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<component::Component> fleet;
  for (std::size_t k = 0; k < size; ++k) {
    std::vector<element::ElementDescription> laws{spring(3e6 * uniform(random)),
                                                  {"dashpot", {{"damping", {1e4 * uniform(random)}}}}};
    for (int i = 0; i < maxwells; ++i) {
      laws.push_back(maxwell(1e6 * uniform(random), 0.01 * std::pow(1e5, uniform(random))));
    }
    if (frictional) {
      laws.push_back(friction(1e4 * uniform(random), 2e-3 * uniform(random), k % 3 == 0 ? 1e-4 : 0.0));
    }
    fleet.emplace_back(laws);
  }
  return fleet;
}

/// Each component's displacement of its own: sines that turn at other times, with noise and pauses.
void expectSameBits(std::mt19937& random, const std::vector<component::Component>& components) {
  std::normal_distribution<double> noise(0.0, 1.0);
  const std::size_t size = components.size();
  component::ComponentFleet fleet(components);
  fleet.rest(1e-4);
  std::vector<component::ComponentState> states;
  for (const component::Component& component : components) {
    states.push_back(component.makeState());
    component.rest(states.back(), 1e-4);
  }
  std::vector<double> displacement(size, 1e-4);
  std::vector<double> force(size);
  for (int tick = 0; tick < 200; ++tick) {
    const double dt = tick % 7 == 0 ? 2e-3 : 1e-3;
    for (std::size_t k = 0; k < size; ++k) {
      const double phase = 0.05 * tick * (1.0 + static_cast<double>(k) / static_cast<double>(size));
      displacement[k] = tick % 11 == 0 ? displacement[k] : 2e-3 * std::sin(phase) + 1e-5 * noise(random);
    }
    fleet.step(dt, displacement.data(), force.data());
    for (std::size_t k = 0; k < size; ++k) {
      ASSERT_EQ(force[k], components[k].step(states[k], dt, displacement[k]).total) << "tick " << tick << ", " << k;
    }
  }
}

/// All kinds of instructions that this processor has, one after the other.
class Fleet : public testing::TestWithParam<kernel::Instructions> {
 protected:
  Fleet() { kernel::useAtMost(GetParam()); }
  ~Fleet() override { kernel::useAtMost(kernel::Instructions::avx512); }
};

INSTANTIATE_TEST_SUITE_P(With, Fleet,
                         testing::Values(kernel::Instructions::any, kernel::Instructions::avx2,
                                         kernel::Instructions::avx512));

TEST_P(Fleet, HasTheBitsOfEachComponentAlone) {
  std::mt19937 random(1);
  for (const std::size_t size : {1, 7, 8, 9, 33}) {
    for (const int maxwells : {0, 1, 5, 12}) {
      expectSameBits(random, randomFleet(random, size, maxwells, true));
      expectSameBits(random, randomFleet(random, size, maxwells, false));
    }
  }
}

TEST_P(Fleet, OfOneDisplacementIsTheFleetOfEqualOnes) {
  std::mt19937 random(2);
  const std::vector<component::Component> components = randomFleet(random, 19, 3, true);
  component::ComponentFleet one(components);
  component::ComponentFleet own(components);
  std::vector<double> of_one(19);
  std::vector<double> of_own(19);
  for (int tick = 0; tick < 500; ++tick) {
    const double z = 2e-3 * std::sin(0.03 * tick);
    one.step(1e-3, z, of_one.data());
    own.step(1e-3, std::vector<double>(19, z).data(), of_own.data());
    ASSERT_EQ(of_one, of_own) << tick;
  }
}

TEST_P(Fleet, TakesLawsThatAreMadeOfMaxwellElements) {
  std::mt19937 random(3);
  const component::Component component({spring(3e6), {"springpot", {{"stiffness", {1e6}}, {"order", {0.1}}}}});
  expectSameBits(random, {component, component, component});
}

/// As randomFleet with friction of one dead band.
std::vector<component::Component> fleetThatTurnsTogether(std::mt19937& random, std::size_t size, int maxwells,
                                                         double dead_band) {
  std::uniform_real_distribution<double> uniform(0.1, 1.0);
  std::vector<component::Component> fleet;
  for (const component::Component& component : randomFleet(random, size, maxwells, false)) {
    std::vector<element::ElementDescription> laws = component.elements();
    laws.push_back(friction(1e4 * uniform(random), 2e-3 * uniform(random), dead_band));
    fleet.emplace_back(laws);
  }
  return fleet;
}

/// Sines with noise and pauses, so that some turns are one sample apart.
std::vector<double> randomLog(std::mt19937& random, std::size_t samples) {
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<double> log(samples, 1e-4);
  for (std::size_t i = 1; i < samples; ++i) {
    const double sine = 2e-3 * std::sin(0.02 * static_cast<double>(i));
    log[i] = noise(random) < -1.5 ? log[i - 1] : sine + (i % 300 < 150 ? 1e-5 * noise(random) : 0.0);
  }
  return log;
}

/// A log in portions of different length, with a step of its own each.
void expectLogHasTheBitsOfEachAlone(std::mt19937& random, const std::vector<component::Component>& components) {
  const std::vector<double> log = randomLog(random, 1500);
  const std::size_t size = components.size();
  component::ComponentFleet fleet(components);
  fleet.rest(log[0]);
  std::vector<double> force(log.size() * size);
  std::vector<double> dt;
  while (dt.size() < log.size()) {
    const std::size_t count = std::min<std::size_t>(log.size() - dt.size(), 1 + random() % 600);
    const double step = random() % 2 == 0 ? 1e-3 : 2e-3;
    fleet.simulate(step, log.data() + dt.size(), count, force.data() + dt.size() * size);
    dt.resize(dt.size() + count, step);
  }
  for (std::size_t k = 0; k < size; ++k) {
    component::ComponentState state = components[k].makeState();
    components[k].rest(state, log[0]);
    for (std::size_t i = 0; i < log.size(); ++i) {
      ASSERT_EQ(force[i * size + k], components[k].step(state, dt[i], log[i]).total) << "sample " << i << ", " << k;
    }
  }
}

TEST_P(Fleet, OnOneLogHasTheBitsOfEachComponentAlone) {
  std::mt19937 random(5);
  for (const std::size_t size : {1, 8, 19}) {
    for (const int maxwells : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}) {
      expectLogHasTheBitsOfEachAlone(random, fleetThatTurnsTogether(random, size, maxwells, 0.0));
      expectLogHasTheBitsOfEachAlone(random, fleetThatTurnsTogether(random, size, maxwells, 5e-5));
      expectLogHasTheBitsOfEachAlone(random, randomFleet(random, size, maxwells, true));
      expectLogHasTheBitsOfEachAlone(random, randomFleet(random, size, maxwells, false));
    }
  }
}

TEST_P(Fleet, OnOneLogGoesOnFromWhereTheComponentsAre) {
  std::mt19937 random(6);
  const std::vector<component::Component> components = fleetThatTurnsTogether(random, 11, 3, 0.0);
  const std::vector<double> log = randomLog(random, 200);
  component::ComponentFleet at_once(components);
  component::ComponentFleet one_by_one(components);
  std::vector<double> force(log.size() * 11);
  std::vector<double> expected(11);
  for (int turn = 0; turn < 3; ++turn) {
    std::vector<double> own(11);
    std::generate(own.begin(), own.end(), [&] { return 1e-6 * static_cast<double>(random() % 1000); });
    if (turn == 2) {  // each its own displacement: from here on they turn each for itself
      at_once.step(1e-3, own.data(), force.data());
      one_by_one.step(1e-3, own.data(), expected.data());
    }
    at_once.simulate(1e-3, log.data(), log.size(), force.data());
    for (std::size_t i = 0; i < log.size(); ++i) {
      one_by_one.step(1e-3, log[i], expected.data());
      ASSERT_TRUE(std::equal(expected.begin(), expected.end(), force.begin() + static_cast<long>(i) * 11)) << i;
    }
  }
}

TEST_P(Fleet, AllocatesNothing) {
  std::mt19937 random(4);
  component::ComponentFleet fleet(randomFleet(random, 20, 5, true));
  std::vector<double> force(20);
  const std::vector<double> log(10, 1e-3);
  std::vector<double> forces(200);
  fleet.step(1e-3, 1e-3, force.data());
  const AllocationCounter counter;
  for (int tick = 0; tick < 100; ++tick) {
    fleet.step(1e-3 + 1e-6 * tick, 1e-3 * std::sin(0.5 * tick), force.data());
    fleet.simulate(1e-3, log.data(), log.size(), forces.data());
  }
  EXPECT_EQ(counter.count(), 0U);
}

TEST_P(Fleet, OfNobodyHasNothingToDo) {
  component::ComponentFleet fleet({});
  fleet.step(1e-3, 1e-3, nullptr);
  EXPECT_EQ(fleet.size(), 0U);
}

std::string refusalOf(const std::vector<component::Component>& components) {
  try {
    const component::ComponentFleet fleet(components);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(FleetOfOneBuild, RefusesWhatDoesNotFit) {
  const component::Component one({spring(1e6), maxwell(1e6, 1.0)});
  EXPECT_THAT(refusalOf({one, component::Component({spring(1e6)})}),
              HasSubstr("component 2 of the fleet: 0 Maxwell elements"));
  EXPECT_THAT(refusalOf({one, component::Component({maxwell(1e6, 1.0), friction(1e3, 1e-3, 0.0)})}),
              HasSubstr("component 2 of the fleet: 1 elements of friction"));
  EXPECT_THAT(refusalOf({component::Component({friction(1e3, 1e-3, 0.0), friction(1e3, 1e-3, 0.0)})}),
              HasSubstr("component 1 of the fleet: two elements of friction"));
  EXPECT_THAT(refusalOf({one, component::Component({{"free_play", {{"gap", {1e-4}}}}})}),
              HasSubstr("component 2 of the fleet: free_play; accepted: springs"));
}

}  // namespace
}  // namespace rubber_suspension::test
