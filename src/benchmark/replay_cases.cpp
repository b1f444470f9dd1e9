// A log offline, many components at each tick, and one log for many sets of parameters, against the plain loop.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <string>

#include "bare_loop.h"
#include "cases.h"
#include "rubber_suspension/component/fleet.h"
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

std::vector<Component> componentsOf(const std::vector<BareParameters>& all) {
  std::vector<Component> components;
  for (const BareParameters& parameters : all) {
    components.emplace_back(elementsOf(parameters));
  }
  return components;
}

struct FleetBench {
  BareFleet bare_fleet;
  std::vector<Component> components;
  std::vector<ComponentState> states;
  ComponentFleet fleet;
  std::vector<double> displacement;
  std::vector<double> bare;
  std::vector<double> library;

  FleetBench(int count, std::size_t ticks)
      : bare_fleet(manyParameters(count), kStep),
        components(componentsOf(manyParameters(count))),
        fleet(components),
        displacement(benchmarkDisplacement(ticks)),
        bare(count),
        library(count) {
    for (const Component& component : components) {
      states.push_back(component.makeState());
    }
  }

  // The signal again and again; where it starts anew the displacement jumps, for all alike.
  void stepOneByOne() {
    for (const double z : displacement) {
      for (std::size_t i = 0; i < components.size(); ++i) {
        library[i] = components[i].step(states[i], kStep, z).total;
      }
    }
  }

  void stepTogether() {
    for (const double z : displacement) {
      fleet.step(kStep, z, library.data());
    }
  }
};

Case fleetCase(int components, std::size_t ticks, const std::string& by, void (FleetBench::*library)()) {
  const auto bench = std::make_shared<FleetBench>(components, ticks);
  Case result;
  result.name = fmt::format("{} components at each tick, {}", components, by);
  result.yardstick = "plain loop over as many";
  result.unit = "component and step";
  result.count = result.yardstick_count = static_cast<double>(ticks) * components;
  result.bare = [bench] {
    for (const double z : bench->displacement) {
      bench->bare_fleet.tick(z, bench->bare);
    }
  };
  result.library = [bench, library] { (bench.get()->*library)(); };
  result.error = [bench] { return relativeDifference(bench->bare, bench->library); };
  result.error_meaning = "of the largest force";
  result.tolerance = kRounding;
  return result;
}

// The sums of squared forces stand for what a fit makes of each candidate.
struct CandidateBench {
  std::vector<BareParameters> parameters;
  std::vector<Component> components;
  std::vector<double> displacement;
  std::vector<double> force;
  std::vector<double> bare;
  std::vector<double> block;
  std::vector<double> library;

  CandidateBench(int count, std::size_t samples)
      : parameters(manyParameters(count)),
        components(componentsOf(parameters)),
        displacement(benchmarkDisplacement(samples)),
        force(samples),
        bare(count),
        block(32 * count),
        library(count) {}

  void runOneByOne() {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      bareLoop(parameters[i], kStep, displacement, force);
      bare[i] = std::inner_product(force.begin() + 1, force.end(), force.begin() + 1, 0.0);
    }
  }

  // Forces of so many samples at once stay in the first-level cache.
  void runTogether() {
    constexpr std::size_t kBlock = 32;
    ComponentFleet fleet(components);
    fleet.rest(displacement[0]);
    std::fill(library.begin(), library.end(), 0.0);
    for (std::size_t first = 1; first < displacement.size(); first += kBlock) {
      const std::size_t size = std::min(kBlock, displacement.size() - first);
      fleet.simulate(kStep, displacement.data() + first, size, block.data());
      addSquares(size);
    }
  }

  void addSquares(std::size_t samples) {
    const double* next = block.data();
    for (std::size_t sample = 0; sample < samples; ++sample) {
      for (double& sum : library) {
        sum += *next * *next;
        ++next;
      }
    }
  }
};

Case candidateCase(std::size_t samples) {
  constexpr int kCandidates = 64;
  constexpr std::size_t kMostSamples = 20000;
  const std::size_t length = std::clamp<std::size_t>(samples, kCandidates, kMostSamples);
  const auto bench = std::make_shared<CandidateBench>(kCandidates, length);
  Case result;
  result.name = fmt::format("one log for {} sets of parameters, `ComponentFleet`", kCandidates);
  result.yardstick = "plain loop, one set after the other";
  result.unit = "set and step";
  result.count = result.yardstick_count = static_cast<double>(length) * kCandidates;
  result.bare = [bench] { bench->runOneByOne(); };
  result.library = [bench] { bench->runTogether(); };
  result.error = [bench] { return relativeDifference(bench->bare, bench->library); };
  result.error_meaning = "of the sum of squares";
  result.tolerance = kRounding;
  return result;
}

}  // namespace

std::vector<Case> replayCases(const BenchmarkSize& size) {
  constexpr std::size_t kMostTicks = 100;
  const std::size_t ticks = std::min(kMostTicks, size.samples);
  return {replayCase(size), fleetCase(size.components, ticks, "`Component::step`", &FleetBench::stepOneByOne),
          fleetCase(size.components, ticks, "`ComponentFleet`", &FleetBench::stepTogether),
          fleetCase(size.components / 16, 16 * ticks, "`ComponentFleet`", &FleetBench::stepTogether),
          candidateCase(size.samples)};
}

}  // namespace rubber_suspension
