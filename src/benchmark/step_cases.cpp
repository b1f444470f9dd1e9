// One component sample by sample, against the plain loop; a surrogate against ten Maxwell elements.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "benchmark/bare_loop.h"
#include "benchmark/cases.h"
#include "benchmark/test_signal.h"
#include "rubber_suspension/component/sample_stream.h"
#include "rubber_suspension/element/residual.h"

namespace rubber_suspension::benchmark {
namespace {

// Both sum the same products in another order: some roundings per step, which relaxation and friction forget.
constexpr double kRounding = 1e-11;

// What a case works on; it lives as long as the functions of the case.
struct Bench {
  BareParameters parameters;
  component::Component component;
  std::vector<double> displacement;
  std::vector<std::int64_t> stamps;
  std::vector<double> steps;
  std::vector<double> bare;
  std::vector<double> library;

  Bench(int maxwell_elements, std::size_t samples, bool even)
      : parameters(bareParameters(maxwell_elements)),
        component(elementsOf(parameters)),
        displacement(benchmarkDisplacement(samples)),
        stamps(even ? evenStamps(samples) : unevenStamps(samples)),
        steps(stepsOf(stamps)),
        bare(samples),
        library(samples) {}
};

void stepThrough(Bench& bench) {
  component::ComponentState state = bench.component.makeState();
  bench.library[0] = bench.component.initialise(state, bench.displacement[0]).total;
  for (std::size_t i = 1; i < bench.displacement.size(); ++i) {
    bench.library[i] = bench.component.step(state, bench.steps[i], bench.displacement[i]).total;
  }
}

void pushThrough(Bench& bench) {
  component::SampleStream stream(bench.component);
  for (std::size_t i = 0; i < bench.displacement.size(); ++i) {
    bench.library[i] = stream.push(bench.stamps[i], bench.displacement[i]).force.total;
  }
}

enum class Baseline { constant_step, own_steps };

Case makeCase(const std::shared_ptr<Bench>& bench, const std::string& name, void (*library)(Bench&),
              Baseline baseline) {
  Case result;
  result.name = name;
  result.unit = "step";
  result.count = result.baseline_count = static_cast<double>(bench->displacement.size());
  result.library = [bench, library] { library(*bench); };
  if (baseline == Baseline::constant_step) {
    result.baseline = "plain loop, constant dt";
    result.bare = [bench] { bareLoop(bench->parameters, kStep, bench->displacement, bench->bare); };
  } else {
    result.baseline = "plain loop, every dt its own";
    result.bare = [bench] { bareLoop(bench->parameters, bench->steps, bench->displacement, bench->bare); };
  }
  result.error = [bench] {
    // Uneven steps are measured against the loop of constant dt, too; the forces are those of the steps themselves.
    bareLoop(bench->parameters, bench->steps, bench->displacement, bench->bare);
    return relativeDifference(bench->bare, bench->library);
  };
  result.error_meaning = "of the largest force";
  result.tolerance = kRounding;
  return result;
}

// A surrogate as a diagnosis writes it, and ten Maxwell elements as the baseline.
struct SurrogateBench {
  element::ResidualBasis basis;
  Eigen::VectorXd weights;
  component::Component surrogate;
  component::Component maxwells;
  std::vector<double> displacement;
  std::vector<double> steps;
  std::vector<double> expected;
  std::vector<double> force;

  SurrogateBench(std::size_t samples, bool even, bool resonant)
      : basis(layoutOf(resonant)),
        weights(weightsOf(basis)),
        surrogate({element::residualDescription(basis, weights, -1e6, 1e6)}),
        maxwells(tenMaxwells()),
        displacement(benchmarkDisplacement(samples)),
        steps(stepsOf(even ? evenStamps(samples) : unevenStamps(samples))),
        expected(samples),
        force(samples) {}

  static element::ResidualBasis::Layout layoutOf(bool resonant) {
    element::ResidualBasis::Layout layout;
    layout.stroke = layout.highest = 2e-3;
    layout.lowest = -2e-3;
    layout.stops = {0.02, 0.04, 0.08, 0.17, 0.34, 0.7};
    layout.times = {8e-3, 0.04, 0.2, 0.8};
    layout.resonant = resonant;
    layout.frequencies = {4.0, 5.2, 6.8, 8.9, 11.7, 15.3, 20.0, 26.0};
    layout.points = 32;
    return layout;
  }

  static Eigen::VectorXd weightsOf(const element::ResidualBasis& basis) {
    return 100.0 * Eigen::ArrayXd::LinSpaced(basis.size(), 1.0, 2.0 * static_cast<double>(basis.size())).cos();
  }

  static std::vector<element::ElementDescription> tenMaxwells() {
    std::vector<element::ElementDescription> elements;
    for (const element::ElementDescription& element : elementsOf(bareParameters(10))) {
      if (element.type == "maxwell") {
        elements.push_back(element);
      }
    }
    return elements;
  }

  void stepThroughAll(const component::Component& component) {
    component::ComponentState state = component.makeState();
    force[0] = component.initialise(state, displacement[0]).total;
    for (std::size_t i = 1; i < displacement.size(); ++i) {
      force[i] = component.step(state, steps[i], displacement[i]).total;
    }
  }

  // The sum over all functions, one by one.
  double error() {
    stepThroughAll(surrogate);
    std::vector<double> memory(element::ResidualBasis::kMemorySize);
    Eigen::VectorXd values(basis.size());
    basis.initialise(displacement[0], memory.data());
    for (std::size_t i = 1; i < displacement.size(); ++i) {
      basis.advance({steps[i], displacement[i], displacement[i] - displacement[i - 1]}, memory.data());
      basis.evaluate(memory.data(), values);
      expected[i] = weights.dot(values);
    }
    expected[0] = force[0];
    return relativeDifference(expected, force);
  }
};

Case surrogateCase(std::size_t samples, bool even, bool resonant) {
  const auto bench = std::make_shared<SurrogateBench>(samples, even, resonant);
  Case result;
  result.name = fmt::format("`Component::step`, {}, a surrogate{}", even ? "constant dt" : "every dt another",
                            resonant ? " with resonators" : "");
  result.baseline = "`Component::step`, ten Maxwell elements alone";
  result.unit = "step";
  result.count = result.baseline_count = static_cast<double>(samples);
  result.library = [bench] { bench->stepThroughAll(bench->surrogate); };
  result.bare = [bench] { bench->stepThroughAll(bench->maxwells); };
  result.error = [bench] { return bench->error(); };
  result.error_meaning = "of the largest force, against its functions one by one";
  result.tolerance = kRounding;
  return result;
}

}  // namespace

std::vector<Case> stepCases(const BenchmarkSize& size) {
  constexpr int kUsual = 5;
  std::vector<Case> cases;
  const auto even = std::make_shared<Bench>(kUsual, size.samples, true);
  const auto uneven = std::make_shared<Bench>(kUsual, size.samples, false);
  cases.push_back(makeCase(even, "`SampleStream::push`, constant dt", pushThrough, Baseline::constant_step));
  cases.push_back(makeCase(uneven, "`Component::step`, every dt another", stepThrough, Baseline::own_steps));
  cases.push_back(makeCase(uneven, "`Component::step`, every dt another", stepThrough, Baseline::constant_step));
  cases.push_back(makeCase(uneven, "`SampleStream::push`, every dt another", pushThrough, Baseline::constant_step));
  for (const int count : {1, 5, 10, 20}) {
    const auto bench = std::make_shared<Bench>(count, size.samples, true);
    cases.push_back(makeCase(bench, fmt::format("`Component::step`, constant dt, {} Maxwell", count), stepThrough,
                             Baseline::constant_step));
  }
  for (const bool evenly : {true, false}) {
    for (const bool resonant : {false, true}) {
      cases.push_back(surrogateCase(size.samples, evenly, resonant));
    }
  }
  return cases;
}

}  // namespace rubber_suspension::benchmark
