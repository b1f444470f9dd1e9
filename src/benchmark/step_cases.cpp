// One component sample by sample, against the plain loop.
#include <fmt/format.h>

#include <memory>

#include "benchmark/bare_loop.h"
#include "benchmark/cases.h"
#include "benchmark/test_signal.h"
#include "rubber_suspension/component/sample_stream.h"

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

enum class Yardstick { constant_step, own_steps };

Case makeCase(const std::shared_ptr<Bench>& bench, const std::string& name, void (*library)(Bench&),
              Yardstick yardstick) {
  Case result;
  result.name = name;
  result.unit = "step";
  result.count = result.yardstick_count = static_cast<double>(bench->displacement.size());
  result.library = [bench, library] { library(*bench); };
  if (yardstick == Yardstick::constant_step) {
    result.yardstick = "plain loop, constant dt";
    result.bare = [bench] { bareLoop(bench->parameters, kStep, bench->displacement, bench->bare); };
  } else {
    result.yardstick = "plain loop, every dt its own";
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

}  // namespace

std::vector<Case> stepCases(const BenchmarkSize& size) {
  constexpr int kUsual = 5;
  std::vector<Case> cases;
  const auto even = std::make_shared<Bench>(kUsual, size.samples, true);
  const auto uneven = std::make_shared<Bench>(kUsual, size.samples, false);
  cases.push_back(makeCase(even, "`SampleStream::push`, constant dt", pushThrough, Yardstick::constant_step));
  cases.push_back(makeCase(uneven, "`Component::step`, every dt another", stepThrough, Yardstick::own_steps));
  cases.push_back(makeCase(uneven, "`Component::step`, every dt another", stepThrough, Yardstick::constant_step));
  cases.push_back(makeCase(uneven, "`SampleStream::push`, every dt another", pushThrough, Yardstick::constant_step));
  for (const int count : {1, 5, 10, 20}) {
    const auto bench = std::make_shared<Bench>(count, size.samples, true);
    cases.push_back(makeCase(bench, fmt::format("`Component::step`, constant dt, {} Maxwell", count), stepThrough,
                             Yardstick::constant_step));
  }
  return cases;
}

}  // namespace rubber_suspension::benchmark
