// Many components side by side against each one alone: the same bits.
#include "rubber_suspension/component/fleet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "support/allocation_counter.h"

namespace rubber_suspension::test {
namespace {

using testing::HasSubstr;

ElementDescription spring(double stiffness) { return {"spring", {{"stiffness", {stiffness}}}}; }

ElementDescription maxwell(double stiffness, double break_frequency) {
  return {"maxwell", {{"stiffness", {stiffness}}, {"break_frequency", {break_frequency}}}};
}

ElementDescription friction(double maximum_force, double displacement, double dead_band) {
  return {"friction",
          {{"maximum_force", {maximum_force}}, {"displacement", {displacement}}, {"dead_band", {dead_band}}}};
}

/// Components of one build whose parameters are drawn each for itself.
std::vector<Component> randomFleet(std::mt19937& random, std::size_t size, int maxwells, bool frictional) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Component> fleet;
  for (std::size_t k = 0; k < size; ++k) {
    std::vector<ElementDescription> laws{spring(3e6 * uniform(random)),
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
void expectSameBits(std::mt19937& random, const std::vector<Component>& components) {
  std::normal_distribution<double> noise(0.0, 1.0);
  const std::size_t size = components.size();
  ComponentFleet fleet(components);
  fleet.rest(1e-4);
  std::vector<ComponentState> states;
  for (const Component& component : components) {
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

TEST(Fleet, HasTheBitsOfEachComponentAlone) {
  std::mt19937 random(1);
  for (const std::size_t size : {1, 7, 8, 9, 33}) {
    for (const int maxwells : {0, 1, 5, 12}) {
      expectSameBits(random, randomFleet(random, size, maxwells, true));
      expectSameBits(random, randomFleet(random, size, maxwells, false));
    }
  }
}

TEST(Fleet, OfOneDisplacementIsTheFleetOfEqualOnes) {
  std::mt19937 random(2);
  const std::vector<Component> components = randomFleet(random, 19, 3, true);
  ComponentFleet one(components);
  ComponentFleet own(components);
  std::vector<double> of_one(19);
  std::vector<double> of_own(19);
  for (int tick = 0; tick < 500; ++tick) {
    const double z = 2e-3 * std::sin(0.03 * tick);
    one.step(1e-3, z, of_one.data());
    own.step(1e-3, std::vector<double>(19, z).data(), of_own.data());
    ASSERT_EQ(of_one, of_own) << tick;
  }
}

TEST(Fleet, TakesLawsThatAreMadeOfMaxwellElements) {
  std::mt19937 random(3);
  const Component component({spring(3e6), {"springpot", {{"stiffness", {1e6}}, {"order", {0.1}}}}});
  expectSameBits(random, {component, component, component});
}

TEST(Fleet, AllocatesNothing) {
  std::mt19937 random(4);
  ComponentFleet fleet(randomFleet(random, 20, 5, true));
  std::vector<double> force(20);
  fleet.step(1e-3, 1e-3, force.data());
  const AllocationCounter counter;
  for (int tick = 0; tick < 100; ++tick) {
    fleet.step(1e-3 + 1e-6 * tick, 1e-3 * std::sin(0.5 * tick), force.data());
  }
  EXPECT_EQ(counter.count(), 0U);
}

TEST(Fleet, OfNobodyHasNothingToDo) {
  ComponentFleet fleet({});
  fleet.step(1e-3, 1e-3, nullptr);
  EXPECT_EQ(fleet.size(), 0U);
}

std::string refusalOf(const std::vector<Component>& components) {
  try {
    const ComponentFleet fleet(components);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Fleet, RefusesWhatDoesNotFit) {
  const Component one({spring(1e6), maxwell(1e6, 1.0)});
  EXPECT_THAT(refusalOf({one, Component({spring(1e6)})}), HasSubstr("component 2 of the fleet: 0 Maxwell elements"));
  EXPECT_THAT(refusalOf({one, Component({maxwell(1e6, 1.0), friction(1e3, 1e-3, 0.0)})}),
              HasSubstr("component 2 of the fleet: 1 elements of friction"));
  EXPECT_THAT(refusalOf({Component({friction(1e3, 1e-3, 0.0), friction(1e3, 1e-3, 0.0)})}),
              HasSubstr("component 1 of the fleet: two elements of friction"));
  EXPECT_THAT(refusalOf({one, Component({{"free_play", {{"gap", {1e-4}}}}})}),
              HasSubstr("component 2 of the fleet: free_play; accepted: springs"));
}

}  // namespace
}  // namespace rubber_suspension::test
