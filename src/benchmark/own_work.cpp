// Benchmarks of the calls that compute forces, and of an estimation.
#include "benchmark/own_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "benchmark/example.h"
#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension::benchmark {
namespace {

void addComponent(std::vector<Work>& all, std::size_t samples) {
  const ExampleParameters parameters;
  const auto even = std::make_shared<ExampleRun>(parameters, Stamps::even, samples);
  const auto uneven = std::make_shared<ExampleRun>(parameters, Stamps::uneven, samples);
  const auto add = [&](const std::string& name, const std::shared_ptr<ExampleRun>& run, void (ExampleRun::*way)()) {
    all.push_back({name, "step", static_cast<double>(samples), [run, way] { (*run.*way)(); }});
  };
  add("`Component::step`, constant dt", even, &ExampleRun::step);
  add("`Component::step`, dt different at every step", uneven, &ExampleRun::step);
  add("`SampleStream::push`, constant dt", even, &ExampleRun::push);
  add("a log offline, `Component::simulate`", even, &ExampleRun::simulate);
  add("a log offline, `simulateLog`", even, &ExampleRun::simulateWholeLog);
}

// Returns the work of stepping components, or bushes of six directions, together along displacements or poses.
template <class Component, class Position>
Work ticksOf(const std::string& name, const std::string& unit, const std::vector<Component>& components,
             const std::vector<Position>& path) {
  auto states = std::make_shared<std::vector<decltype(components[0].makeState())>>();
  std::transform(components.begin(), components.end(), std::back_inserter(*states),
                 [](const Component& component) { return component.makeState(); });
  const auto run = [states, components, path] {
    for (const Position& position : path) {
      for (std::size_t i = 0; i < components.size(); ++i) {
        components[i].step((*states)[i], kStep, position);
      }
    }
  };
  return {name, unit, static_cast<double>(components.size() * path.size()), run};
}

void addTicks(std::vector<Work>& all, std::size_t samples) {
  constexpr int kComponents = 1000;
  constexpr std::size_t kTicks = 100;
  std::vector<component::Component> components;
  for (int i = 0; i < kComponents; ++i) {
    const double factor = 1.0 + static_cast<double>(i) / kComponents;
    components.emplace_back(ExampleParameters().scaled(factor, factor).elements());
  }
  all.push_back(ticksOf(fmt::format("{} components at each tick, `Component::step`", kComponents), "component and step",
                        components, benchmarkDisplacement(kTicks)));
  const component::SixDirections bush(exampleBush(component::Coupling::rectangular));
  std::vector<Eigen::Isometry3d> poses;
  for (const double z : benchmarkDisplacement(samples)) {
    poses.push_back(bush.pose((component::SixNumbers() << z, z, z, 50.0 * z, 50.0 * z, 50.0 * z).finished()));
  }
  all.push_back(
      ticksOf("`SixDirections::step`, rectangular", "step of six", std::vector<component::SixDirections>{bush}, poses));
}

// Estimates the example of O. Polach, "Modelling of rubber components using estimated parameters" (IAVSD 2015).
Work estimation() {
  constexpr int kRuns = 100;  // so that one run is long compared to the resolution of the clock
  estimation::Specification specification;
  specification.set("static_stiffness", 3.0e6);   // [N/m]
  specification.set("dynamic_stiffness", 4.2e6);  // [N/m]
  specification.set("nominal_frequency", 4.0);    // [Hz]
  specification.set("maximum_stiffness", 4.9e6);  // [N/m]
  specification.set("high_frequency", 25.0);      // [Hz]
  const auto run = [specification] {
    for (int i = 0; i < kRuns; ++i) {
      estimation::estimate(estimation::Model::multi_maxwell, specification);
    }
  };
  return {"estimation from five inputs, checks included", "estimation", kRuns, run};
}

}  // namespace

std::vector<Work> forces(std::size_t samples) {
  std::vector<Work> all;
  addComponent(all, samples);
  addTicks(all, samples);
  all.push_back(estimation());
  return all;
}

std::string row(const Work& work, int runs) {
  std::vector<double> seconds;
  work.run();
  for (int i = 0; i < runs; ++i) {
    seconds.push_back(secondsOf(work.run, work.clock) / work.count);
  }
  const io::Spread spread = spreadOf(seconds);
  return fmt::format("| {} | **{}** per {} | {} to {} |\n", work.name, readable(spread.median), work.unit,
                     readable(spread.lower), readable(spread.upper));
}

}  // namespace rubber_suspension::benchmark
