// One log for many components against each one alone, on every path: RapidCheck draws the paths and shrinks those that
// fail. Needs RapidCheck.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <vector>

#include "rubber_suspension/component/fleet.h"

namespace rubber_suspension::test {
namespace {

// The same paths in every run, unless the environment asks for others.
const bool kSeeded = setenv("RC_PARAMS", "seed=20150817", 0) == 0;

constexpr double kMicrometre = 1e-6;

/// Integers make short counterexamples, and displacements that repeat and lie on reference points.
std::vector<double> anyPath() {
  std::vector<double> path;
  for (const int micrometres : *rc::gen::container<std::vector<int>>(rc::gen::inRange(-20, 21))) {
    path.push_back(kMicrometre * micrometres);
  }
  return path;
}

/// Nine components, one more than lie side by side, that differ in stiffness and friction.
std::vector<component::Component> fleetOf(int maxwells, double dead_band) {
  std::vector<component::Component> fleet;
  for (int k = 1; k <= 9; ++k) {
    std::vector<element::ElementDescription> laws{{"spring", {{"stiffness", {1e6 * k}}}}};
    for (int i = 0; i < maxwells; ++i) {
      laws.push_back({"maxwell", {{"stiffness", {2e5 * k}}, {"break_frequency", {0.1 * (i + 1) * k}}}});
    }
    laws.push_back(
        {"friction", {{"maximum_force", {1e3 * k}}, {"displacement", {1e-5 * k}}, {"dead_band", {dead_band}}}});
    fleet.emplace_back(laws);
  }
  return fleet;
}

RC_GTEST_PROP(AnyLogForAFleet, HasTheBitsOfEachComponentAlone, ()) {
  const std::vector<double> path = anyPath();
  const int maxwells = *rc::gen::inRange(0, 9);
  const double dead_band = kMicrometre * *rc::gen::inRange(0, 10);
  kernel::useAtMost(
      *rc::gen::element(kernel::Instructions::any, kernel::Instructions::avx2, kernel::Instructions::avx512));
  const std::vector<component::Component> components = fleetOf(maxwells, dead_band);
  component::ComponentFleet fleet(components);
  std::vector<double> force(path.size() * components.size());
  fleet.simulate(1e-3, path.data(), path.size(), force.data());
  kernel::useAtMost(kernel::Instructions::avx512);
  for (std::size_t k = 0; k < components.size(); ++k) {
    component::ComponentState state = components[k].makeState();
    for (std::size_t i = 0; i < path.size(); ++i) {
      RC_ASSERT(force[i * components.size() + k] == components[k].step(state, 1e-3, path[i]).total);
    }
  }
}

}  // namespace
}  // namespace rubber_suspension::test
