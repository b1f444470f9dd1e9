// One component, sample by sample and as a log, and many components at each tick, compared with the handwritten loop.
#include <fmt/format.h>

#include <algorithm>

#include "benchmark/bare_loop.h"
#include "benchmark/cases.h"
#include "benchmark/example.h"

namespace rubber_suspension::benchmark {
namespace {

constexpr int kElements = 5;

// The library and the loop of a row in the table, with their forces at the samples of the log.
struct Bench {
  ExampleParameters parameters;
  ExampleRun run;
  std::vector<double> bare_steps;  // a single value if the step is constant
  std::vector<double> bare;
  std::vector<double>& library = run.force;

  Bench(int maxwells, Stamps kind, std::size_t samples)
      : parameters(maxwells),
        run(parameters, kind, samples),
        bare_steps(kind == Stamps::even ? std::vector<double>{kStep} : run.steps),
        bare(samples) {}

  void plainLoop() { bareLoop(parameters, bare_steps, run.log.displacement, bare); }
};

void addSteps(std::vector<Case>& cases, std::size_t samples) {
  const auto even = std::make_shared<Bench>(kElements, Stamps::even, samples);
  const auto uneven = std::make_shared<Bench>(kElements, Stamps::uneven, samples);
  const auto add = [&](const std::shared_ptr<Bench>& bench, const std::string& name, void (ExampleRun::*way)()) {
    const std::string loop = bench == uneven ? "plain loop, every dt its own" : "plain loop, constant dt";
    cases.push_back(forceCase(bench, name, [way](Bench& work) { (work.run.*way)(); }, loop, &Bench::plainLoop));
  };
  add(even, "`SampleStream::push`, constant dt", &ExampleRun::push);
  add(uneven, "`Component::step`, dt different at every step", &ExampleRun::step);
  add(uneven, "`SampleStream::push`, every dt another", &ExampleRun::push);
  for (const int count : {1, 5, 10, 20}) {
    add(std::make_shared<Bench>(count, Stamps::even, samples),
        fmt::format("`Component::step`, constant dt, {} Maxwell", count), &ExampleRun::step);
  }
  add(even, "a log offline, `Component::simulate`", &ExampleRun::simulate);
  add(even, "a log offline, `simulateLog`", &ExampleRun::simulateWholeLog);
}

// Components whose stiffnesses and forces differ by up to a factor of two.
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
      const ExampleParameters parameters = ExampleParameters(kElements).scaled(factor, factor);
      members.emplace_back(parameters);
      members.back().setStep(BareMaxwells<kElements>(parameters), kStep);
      components.emplace_back(parameters.elements());
      states.push_back(components.back().makeState());
    }
  }

  // Each run repeats the signal, so the displacement jumps at the start of a run, for the library and the loop alike.
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
