// A log offline, many components at each tick, and one log for many sets of parameters, against the plain loop.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <string>

#include "benchmark/bare_lanes.h"
#include "benchmark/cases.h"
#include "benchmark/test_signal.h"
#include "rubber_suspension/component/fleet.h"
#include "rubber_suspension/gap/replay.h"

namespace rubber_suspension::benchmark {
namespace {

constexpr double kRounding = 1e-11;

enum class Yardstick { plain, vectors };
// A log with its stamps, all checked and judged, or displacements at a constant distance alone.
enum class Offline { log, displacements };
constexpr int kMaxwellElements = 5;

struct ReplayBench {
  BareParameters parameters = bareParameters(kMaxwellElements);
  component::Component component{elementsOf(parameters)};
  log::Log log;
  std::vector<double> bare;
  std::vector<double> library;

  explicit ReplayBench(std::size_t samples) : bare(samples) {
    log.name = "benchmark";
    log.stamp = evenStamps(samples);
    log.displacement = benchmarkDisplacement(samples);
  }

  void simulate() {
    component::ComponentState state = component.makeState();
    library.resize(log.size());
    library[0] = component.rest(state, log.displacement[0]).total;
    component.simulate(state, kStep, log.displacement.data() + 1, log.size() - 1, library.data() + 1);
  }
};

Case replayCase(const BenchmarkSize& size, Offline offline, Yardstick yardstick) {
  const std::size_t samples = std::max<std::size_t>(size.samples, 16) / 8 * 8 + 1;
  const auto bench = std::make_shared<ReplayBench>(samples);
  const bool plain = yardstick == Yardstick::plain;
  Case result;
  result.name = offline == Offline::log ? "a log offline, `simulateLog`" : "a log offline, `Component::simulate`";
  result.yardstick = plain ? "plain loop, constant dt" : "state-space form over blocks of samples, by vectors";
  result.unit = "step";
  result.count = result.yardstick_count = static_cast<double>(samples);
  result.bare = [bench, plain] {
    if (plain) {
      bareLoop(bench->parameters, kStep, bench->log.displacement, bench->bare);
    } else {
      bareBlockLoop(bench->parameters, kStep, bench->log.displacement, bench->bare);
    }
  };
  result.library = [bench, offline] {
    if (offline == Offline::log) {
      bench->library = gap::simulateLog(bench->component, bench->log);
    } else {
      bench->simulate();
    }
  };
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

std::vector<component::Component> componentsOf(const std::vector<BareParameters>& all) {
  std::vector<component::Component> components;
  for (const BareParameters& parameters : all) {
    components.emplace_back(elementsOf(parameters));
  }
  return components;
}

struct FleetBench {
  BareFleet bare_fleet;
  BareLanes bare_lanes;
  std::vector<component::Component> components;
  std::vector<component::ComponentState> states;
  component::ComponentFleet fleet;
  std::vector<double> displacement;
  std::vector<double> own_displacement;
  std::vector<double> bare;
  std::vector<double> library;

  FleetBench(int count, std::size_t ticks)
      : bare_fleet(manyParameters(count), kStep),
        bare_lanes(manyParameters(count), kStep),
        components(componentsOf(manyParameters(count))),
        fleet(components),
        displacement(benchmarkDisplacement(ticks)),
        own_displacement(count),
        bare(count),
        library(count) {
    for (const component::Component& component : components) {
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
      std::fill(own_displacement.begin(), own_displacement.end(), z);
      fleet.step(kStep, own_displacement.data(), library.data());
    }
  }

  void stepPlain() {
    for (const double z : displacement) {
      bare_fleet.tick(z, bare);
    }
  }

  void stepLanes() {
    for (const double z : displacement) {
      std::fill(own_displacement.begin(), own_displacement.end(), z);
      bare_lanes.tick(own_displacement.data(), bare.data());
    }
  }
};

Case fleetCase(int components, std::size_t ticks, const std::string& by, void (FleetBench::*library)(),
               Yardstick yardstick) {
  const auto bench = std::make_shared<FleetBench>(components, ticks);
  const auto bare = yardstick == Yardstick::plain ? &FleetBench::stepPlain : &FleetBench::stepLanes;
  Case result;
  result.name = fmt::format("{} components at each tick, {}", components, by);
  result.yardstick = yardstick == Yardstick::plain ? "plain loop over as many" : "vectors over as many";
  result.unit = "component and step";
  result.count = result.yardstick_count = static_cast<double>(ticks) * components;
  result.bare = [bench, bare] { (bench.get()->*bare)(); };
  result.library = [bench, library] { (bench.get()->*library)(); };
  result.error = [bench] { return relativeDifference(bench->bare, bench->library); };
  result.error_meaning = "of the largest force";
  result.tolerance = kRounding;
  return result;
}

// The sums of squared forces stand for what a fit makes of each candidate.
struct CandidateBench {
  static constexpr std::size_t kBlock = 64;  // samples at once, whose forces stay in the first-level cache

  std::vector<BareParameters> parameters;
  BareLanes lanes;
  std::vector<component::Component> components;
  std::vector<double> displacement;
  std::vector<double> force;
  std::vector<double> bare;
  std::vector<double> block;
  std::vector<double> library;

  CandidateBench(int count, std::size_t samples)
      : parameters(manyParameters(count)),
        lanes(parameters, kStep),
        components(componentsOf(parameters)),
        displacement(benchmarkDisplacement(samples)),
        force(samples),
        bare(count),
        block(kBlock * static_cast<std::size_t>(count)),
        library(count) {}

  void runOneByOne() {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      bareLoop(parameters[i], kStep, displacement, force);
      bare[i] = std::inner_product(force.begin() + 1, force.end(), force.begin() + 1, 0.0);
    }
  }

  void runTogether() {
    component::ComponentFleet fleet(components);
    fleet.rest(displacement[0]);
    std::fill(library.begin(), library.end(), 0.0);
    for (std::size_t first = 1; first < displacement.size(); first += kBlock) {
      const std::size_t size = std::min(kBlock, displacement.size() - first);
      fleet.simulate(kStep, displacement.data() + first, size, block.data());
      addSquares(size);
    }
  }

  // Eight sets at a time, so that their sums stay in registers.
  void addSquares(std::size_t samples) {
    constexpr std::size_t kSets = 8;
    for (std::size_t first = 0; first < library.size(); first += kSets) {
      double sums[kSets] = {};
      for (std::size_t sample = 0; sample < samples; ++sample) {
        const double* force_of = block.data() + sample * library.size() + first;
        for (std::size_t i = 0; i < kSets; ++i) {
          sums[i] += force_of[i] * force_of[i];
        }
      }
      for (std::size_t i = 0; i < kSets; ++i) {
        library[first + i] += sums[i];
      }
    }
  }
};

Case candidateCase(std::size_t samples, Yardstick yardstick) {
  constexpr int kCandidates = 64;
  constexpr std::size_t kMostSamples = 20000;
  const std::size_t length = std::clamp<std::size_t>(samples, kCandidates, kMostSamples);
  const auto bench = std::make_shared<CandidateBench>(kCandidates, length);
  Case result;
  result.name = fmt::format("one log for {} sets of parameters, `ComponentFleet`", kCandidates);
  const bool plain = yardstick == Yardstick::plain;
  result.yardstick = plain ? "plain loop, one set after the other" : "vectors of sets, turns in common";
  result.unit = "set and step";
  result.count = result.yardstick_count = static_cast<double>(length) * kCandidates;
  result.bare = [bench, plain] {
    if (plain) {
      bench->runOneByOne();
    } else {
      bench->lanes.sumSquares(bench->displacement, bench->bare.data());
    }
  };
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
  const int many = size.components / 8 * 8;
  std::vector<Case> cases;
  cases.push_back(fleetCase(many, ticks, "`Component::step`", &FleetBench::stepOneByOne, Yardstick::plain));
  for (const Yardstick yardstick : {Yardstick::plain, Yardstick::vectors}) {
    cases.push_back(replayCase(size, Offline::displacements, yardstick));
    cases.push_back(replayCase(size, Offline::log, yardstick));
    cases.push_back(fleetCase(many, ticks, "`ComponentFleet`", &FleetBench::stepTogether, yardstick));
    cases.push_back(fleetCase(64, 16 * ticks, "`ComponentFleet`", &FleetBench::stepTogether, yardstick));
    cases.push_back(candidateCase(size.samples, yardstick));
  }
  return cases;
}

}  // namespace rubber_suspension::benchmark
