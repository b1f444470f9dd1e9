// One component on a motion, sample by sample and as a log, and many at each tick, against the plain loop.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "benchmark/bare_loop.h"
#include "benchmark/cases.h"
#include "benchmark/test_signal.h"
#include "rubber_suspension/component/sample_stream.h"
#include "rubber_suspension/gap/replay.h"

namespace rubber_suspension::benchmark {
namespace {

constexpr int kElements = 5;
// Both sides of a row: each leaves its forces at the samples of the log.
struct Bench {
  BareParameters parameters;
  component::Component component;
  log::Log log;
  std::vector<double> steps;       // that end at each sample; the first is 0
  std::vector<double> bare_steps;  // one where it holds throughout
  std::vector<double> bare;
  std::vector<double> library;

  Bench(const BareParameters& given, Stamps kind, std::size_t samples)
      : parameters(given), component(elementsOf(given)), steps(samples), bare(samples), library(samples) {
    log.name = "benchmark";
    log.stamp = stampsOf(kind, samples);
    log.displacement = benchmarkDisplacement(samples);
    std::adjacent_difference(log.stamp.begin(), log.stamp.end(), steps.begin(),
                             [](auto end, auto begin) { return static_cast<double>(end - begin) / 1e9; });
    bare_steps = kind == Stamps::even ? std::vector<double>{kStep} : steps;
  }
};

void plainLoop(Bench& bench) { bareLoop(bench.parameters, bench.bare_steps, bench.log.displacement, bench.bare); }

void stepThrough(Bench& bench) {
  component::ComponentState state = bench.component.makeState();
  bench.library[0] = bench.component.initialise(state, bench.log.displacement[0]).total;
  for (std::size_t i = 1; i < bench.library.size(); ++i) {
    bench.library[i] = bench.component.step(state, bench.steps[i], bench.log.displacement[i]).total;
  }
}

void pushThrough(Bench& bench) {
  component::SampleStream stream(bench.component);
  for (std::size_t i = 0; i < bench.library.size(); ++i) {
    bench.library[i] = stream.push(bench.log.stamp[i], bench.log.displacement[i]).force.total;
  }
}

void simulate(Bench& bench) {
  component::ComponentState state = bench.component.makeState();
  const std::vector<double>& z = bench.log.displacement;
  bench.library[0] = bench.component.initialise(state, z[0]).total;
  bench.component.simulate(state, kStep, z.data() + 1, z.size() - 1, bench.library.data() + 1);
}

void simulateWholeLog(Bench& bench) { bench.library = gap::simulateLog(bench.component, bench.log); }

void addSteps(std::vector<Case>& cases, std::size_t samples) {
  const auto even = std::make_shared<Bench>(bareParameters(kElements), Stamps::even, samples);
  const auto uneven = std::make_shared<Bench>(bareParameters(kElements), Stamps::uneven, samples);
  const auto add = [&](const std::shared_ptr<Bench>& bench, const std::string& name, void (*side)(Bench&)) {
    const std::string loop = bench == uneven ? "plain loop, every dt its own" : "plain loop, constant dt";
    cases.push_back(forceCase(bench, name, side, loop, plainLoop));
  };
  add(even, "`SampleStream::push`, constant dt", pushThrough);
  add(uneven, "`Component::step`, every dt another", stepThrough);
  add(uneven, "`SampleStream::push`, every dt another", pushThrough);
  for (const int count : {1, 5, 10, 20}) {
    add(std::make_shared<Bench>(bareParameters(count), Stamps::even, samples),
        fmt::format("`Component::step`, constant dt, {} Maxwell", count), stepThrough);
  }
  add(even, "a log offline, `Component::simulate`", simulate);
  add(even, "a log offline, `simulateLog`", simulateWholeLog);
}

// Components that differ in all stiffnesses and forces by up to a factor of two.
struct ManyBench {
  std::vector<BareComponent<kElements>> members;
  std::vector<component::Component> components;
  std::vector<component::ComponentState> states;
  std::vector<double> displacement;
  double last = 0.0;
  std::vector<double> bare;
  std::vector<double> library;

  ManyBench(int count, std::size_t ticks) : displacement(benchmarkDisplacement(ticks)), bare(count), library(count) {
    for (int i = 0; i < count; ++i) {
      const double factor = 1.0 + static_cast<double>(i) / count;
      const BareParameters parameters = bareParameters(kElements).scaled(factor, factor);
      members.emplace_back(parameters);
      members.back().setStep(BareMaxwells<kElements>(parameters), kStep);
      components.emplace_back(elementsOf(parameters));
      states.push_back(components.back().makeState());
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
      for (std::size_t i = 0; i < members.size(); ++i) {
        bare[i] = members[i].tick(z, z - last);
      }
      last = z;
    }
  }
};

Case manyCase(int components, std::size_t ticks) {
  const auto bench = std::make_shared<ManyBench>(components, ticks);
  Case result = forceCase(bench, fmt::format("{} components at each tick, `Component::step`", components),
                          &ManyBench::stepAll, "plain loop over as many", &ManyBench::stepPlain);
  result.unit = "component and step";
  result.count = result.baseline_count = static_cast<double>(ticks) * components;
  return result;
}

}  // namespace

std::vector<Case> forceCases(const BenchmarkSize& size) {
  constexpr std::size_t kMostTicks = 100;
  std::vector<Case> cases;
  addSteps(cases, size.samples);
  cases.push_back(manyCase(size.components, std::min(kMostTicks, size.samples)));
  return cases;
}

}  // namespace rubber_suspension::benchmark
