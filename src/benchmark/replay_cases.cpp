// A log offline, and many components at each tick, against the plain loop.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "bare_loop.h"
#include "cases.h"
#include "rubber_suspension/io/replay.h"
#include "test_signal.h"

namespace rubber_suspension {
namespace {

constexpr double kRounding = 1e-11;
constexpr int kMaxwellElements = 5;

struct ReplayBench {
  BareParameters parameters = bareParameters(kMaxwellElements);
  Component component{elementsOf(parameters)};
  Log log;
  std::vector<double> bare;
  std::vector<double> library;

  explicit ReplayBench(std::size_t samples) : bare(samples) {
    log.name = "benchmark";
    log.stamp = evenStamps(samples);
    log.displacement = benchmarkDisplacement(samples);
  }
};

Case replayCase(const BenchmarkSize& size) {
  const auto bench = std::make_shared<ReplayBench>(size.samples);
  Case result;
  result.name = "a log offline, `simulateLog`";
  result.yardstick = "plain loop, constant dt";
  result.unit = "step";
  result.count = result.yardstick_count = static_cast<double>(size.samples);
  result.bare = [bench] { bareLoop(bench->parameters, kStep, bench->log.displacement, bench->bare); };
  result.library = [bench] { bench->library = simulateLog(bench->component, bench->log); };
  result.error = [bench] { return relativeDifference(bench->bare, bench->library); };
  result.error_meaning = "of the largest force";
  result.tolerance = kRounding;
  return result;
}

// Components that differ in all stiffnesses and forces by up to a factor of two.
std::vector<BareParameters> manyParameters(int count) {
  std::vector<BareParameters> all;
  for (int i = 0; i < count; ++i) {
    const double factor = 1.0 + static_cast<double>(i) / count;
    BareParameters parameters = bareParameters(kMaxwellElements);
    parameters.spring *= factor;
    parameters.maximum_force *= factor;
    for (double& stiffness : parameters.stiffness) {
      stiffness *= factor;
    }
    all.push_back(parameters);
  }
  return all;
}

struct FleetBench {
  BareFleet fleet;
  std::vector<Component> components;
  std::vector<ComponentState> states;
  std::vector<double> displacement;
  std::vector<double> bare;
  std::vector<double> library;

  FleetBench(int count, std::size_t ticks)
      : fleet(manyParameters(count), kStep), displacement(benchmarkDisplacement(ticks)), bare(count), library(count) {
    for (const BareParameters& parameters : manyParameters(count)) {
      components.emplace_back(elementsOf(parameters));
      states.push_back(components.back().makeState());
    }
  }

  // The signal again and again; where it starts anew the displacement jumps, for both alike.
  void stepAll() {
    for (const double z : displacement) {
      for (std::size_t i = 0; i < components.size(); ++i) {
        library[i] = components[i].step(states[i], kStep, z).total;
      }
    }
  }
};

Case fleetCase(const BenchmarkSize& size) {
  constexpr std::size_t kMostTicks = 100;
  const std::size_t ticks = std::min(kMostTicks, size.samples);
  const auto bench = std::make_shared<FleetBench>(size.components, ticks);
  Case result;
  result.name = fmt::format("{} components at each tick, `Component::step`", size.components);
  result.yardstick = "plain loop over as many";
  result.unit = "component and step";
  result.count = result.yardstick_count = static_cast<double>(ticks) * size.components;
  result.bare = [bench] {
    for (const double z : bench->displacement) {
      bench->fleet.tick(z, bench->bare);
    }
  };
  result.library = [bench] { bench->stepAll(); };
  result.error = [bench] { return relativeDifference(bench->bare, bench->library); };
  result.error_meaning = "of the largest force";
  result.tolerance = kRounding;
  return result;
}

}  // namespace

std::vector<Case> replayCases(const BenchmarkSize& size) { return {replayCase(size), fleetCase(size)}; }

}  // namespace rubber_suspension
