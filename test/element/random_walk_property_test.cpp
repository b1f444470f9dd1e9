// Properties that hold on every path. RapidCheck draws the paths and shortens those that fail.
#include <rapidcheck/gtest.h>

#include "element/driver.h"
#include "element/typical_elements.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

// Every run draws the same paths, unless the environment variable RC_PARAMS is set.
const bool kSeeded = setenv("RC_PARAMS", "seed=20150817", 0) == 0;

struct Move {
  double dt;
  double displacement;
};

/// Draws integers, so that counterexamples are short: displacements in um, durations in decades from 1 ns to 1000 s.
std::vector<Move> anyPath() {
  const auto numbers = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(-10000, 10001), rc::gen::inRange(-9, 4)));
  std::vector<Move> path;
  path.reserve(numbers.size());
  for (const auto& [micrometres, decade] : numbers) {
    path.push_back({std::pow(10.0, decade), 1e-6 * micrometres});
  }
  return path;
}

RC_GTEST_PROP(AnyPath, LeavesForcesAndMemoryFinite, ()) {
  const std::vector<Move> path = anyPath();
  for (const element::ElementDescription& description : typicalElements()) {
    const component::Component component = subject(description);
    component::ComponentState state = component.makeState();
    for (const Move& move : path) {
      RC_ASSERT(std::isfinite(component.step(state, move.dt, move.displacement).total));
    }
    for (const double value : state.memory()) {
      RC_ASSERT(std::isfinite(value));
    }
  }
}

RC_GTEST_PROP(AnyPath, CanBeContinuedFromSavedNumbers, ()) {
  const std::vector<Move> before = anyPath();
  const std::vector<Move> after = anyPath();
  for (const element::ElementDescription& description : typicalElements()) {
    const component::Component component = subject(description);
    component::ComponentState state = component.makeState();
    for (const Move& move : before) {
      component.step(state, move.dt, move.displacement);
    }
    component::ComponentState restored = component.makeState();
    component.restore(restored, state.displacement(), state.memory());
    for (const Move& move : after) {
      RC_ASSERT(component.step(restored, move.dt, move.displacement).total ==
                component.step(state, move.dt, move.displacement).total);
    }
  }
}

RC_GTEST_PROP(AnyPath, FrictionStaysWithinItsMaximum, ()) {
  const std::vector<Move> path = anyPath();
  for (const char* law :
       {"friction maximum_force=5e3 displacement=2e-4", "friction maximum_force=5e3 displacement=2e-4 dead_band=1e-4",
        "iwan maximum_force=5e3 displacement=2e-4", "coulomb_friction maximum_force=5e3 stiffness=1e7",
        "viscoplastic_friction stiffness=1e7 yield_displacement=5e-4 half_rate=5e-3",
        "sliding_maxwell stiffness=1e7 break_frequency=2 yield_displacement=5e-4"}) {
    Driver driver(law);
    for (const Move& move : path) {
      RC_ASSERT(std::abs(driver.step(move.dt, move.displacement)) <= 5e3 * (1.0 + 1e-12));  // rounding of 16 sliders
    }
  }
}

// An excursion within a range that was passed before has no effect after its return.
RC_GTEST_PROP(AnyPath, IwanClosesAnyMinorLoop, ()) {
  Driver driver("iwan maximum_force=5e3 displacement=2e-4");
  for (const Move& move : anyPath()) {
    driver.step(move.dt, move.displacement);
  }
  driver.step(1.0, -2e-2);
  const double top = 1e-6 * *rc::gen::inRange(-9999, 10000);
  const double force = driver.step(1.0, top);
  for (const int share : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1001))) {
    driver.step(1.0, top - (top + 2e-2) * share / 1000.0);
  }
  RC_ASSERT(std::abs(driver.step(1.0, top) - force) <= 1e-12 * 5e3);
}

// For every symmetric law, a mirrored path gives the mirrored force.
RC_GTEST_PROP(AnyPath, MirroredGivesMirroredForce, ()) {
  const std::vector<Move> path = anyPath();
  for (const element::ElementDescription& description : typicalElements()) {
    const bool one_sided = isOneOf(description, {"asymmetric_stiffness", "spring_table", "bump_stop", "force_offset",
                                                 "force_drift", "residual", "position_dashpot", "maxwell_along_curve",
                                                 "dashpot_along_curve", "sliders_along_curve"}) ||
                           description.values.count("side") != 0;
    if (one_sided) {
      continue;
    }
    const component::Component component = subject(description);
    component::ComponentState up = component.makeState();
    component::ComponentState down = component.makeState();
    for (const Move& move : path) {
      const double force = component.step(up, move.dt, move.displacement).total;
      // The forces are equal to the last bit, except behind mounts, whose solver starts from the other side.
      RC_ASSERT(std::abs(force + component.step(down, move.dt, -move.displacement).total) <=
                1e-9 * std::abs(force) + 1e-6);
    }
  }
}

}  // namespace
}  // namespace rubber_suspension::test
