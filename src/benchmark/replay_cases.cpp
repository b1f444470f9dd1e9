// A log offline, and many components at each tick, against the plain loop.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "benchmark/bare_lanes.h"
#include "benchmark/cases.h"
#include "benchmark/test_signal.h"
#include "rubber_suspension/gap/replay.h"

namespace rubber_suspension::benchmark {
namespace {

constexpr double kRounding = 1e-11;

enum class Baseline { plain, vectors };
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
    library[0] = component.initialise(state, log.displacement[0]).total;
    component.simulate(state, kStep, log.displacement.data() + 1, log.size() - 1, library.data() + 1);
  }
};

Case replayCase(const BenchmarkSize& size, Offline offline, Baseline baseline) {
  const std::size_t samples = std::max<std::size_t>(size.samples, 16) / 8 * 8 + 1;
  const auto bench = std::make_shared<ReplayBench>(samples);
  const bool plain = baseline == Baseline::plain;
  Case result;
  result.name = offline == Offline::log ? "a log offline, `simulateLog`" : "a log offline, `Component::simulate`";
  result.baseline = plain ? "plain loop, constant dt" : "state-space form over blocks of samples, by vectors";
  result.unit = "step";
  result.count = result.baseline_count = static_cast<double>(samples);
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

struct ManyBench {
  BareMany bare_many;
  std::vector<component::Component> components;
  std::vector<component::ComponentState> states;
  std::vector<double> displacement;
  std::vector<double> bare;
  std::vector<double> library;

  ManyBench(int count, std::size_t ticks)
      : bare_many(manyParameters(count), kStep),
        components(componentsOf(manyParameters(count))),
        displacement(benchmarkDisplacement(ticks)),
        bare(count),
        library(count) {
    for (const component::Component& component : components) {
      states.push_back(component.makeState());
    }
  }

  // The signal again and again; where it starts again the displacement jumps, for all alike.
  void stepAll() {
    for (const double z : displacement) {
      for (std::size_t i = 0; i < components.size(); ++i) {
        library[i] = components[i].step(states[i], kStep, z).total;
      }
    }
  }

  void stepPlain() {
    for (const double z : displacement) {
      bare_many.tick(z, bare);
    }
  }
};

Case manyCase(int components, std::size_t ticks) {
  const auto bench = std::make_shared<ManyBench>(components, ticks);
  Case result;
  result.name = fmt::format("{} components at each tick, `Component::step`", components);
  result.baseline = "plain loop over as many";
  result.unit = "component and step";
  result.count = result.baseline_count = static_cast<double>(ticks) * components;
  result.bare = [bench] { bench->stepPlain(); };
  result.library = [bench] { bench->stepAll(); };
  result.error = [bench] { return relativeDifference(bench->bare, bench->library); };
  result.error_meaning = "of the largest force";
  result.tolerance = kRounding;
  return result;
}

}  // namespace

std::vector<Case> replayCases(const BenchmarkSize& size) {
  constexpr std::size_t kMostTicks = 100;
  std::vector<Case> cases;
  cases.push_back(manyCase(size.components, std::min(kMostTicks, size.samples)));
  for (const Baseline baseline : {Baseline::plain, Baseline::vectors}) {
    cases.push_back(replayCase(size, Offline::displacements, baseline));
    cases.push_back(replayCase(size, Offline::log, baseline));
  }
  return cases;
}

}  // namespace rubber_suspension::benchmark
