// One component on a motion, sample by sample and as a log, and many at each tick, against the plain loop and general
// solvers.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "benchmark/bare_loop.h"
#include "benchmark/cases.h"
#include "benchmark/force_case.h"
#include "benchmark/peer/peers.h"
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
  std::vector<double> steps;
  std::vector<double> bare;
  std::vector<double> library;

  Bench(const BareParameters& given, const std::vector<std::int64_t>& stamps)
      : parameters(given),
        component(elementsOf(given)),
        steps(stepsOf(stamps)),
        bare(stamps.size()),
        library(stamps.size()) {
    log.name = "benchmark";
    log.stamp = stamps;
    log.displacement = benchmarkDisplacement(stamps.size());
  }
};

void plainLoop(Bench& bench) { bareLoop(bench.parameters, {kStep}, bench.log.displacement, bench.bare); }
void plainLoopOfEachStep(Bench& bench) { bareLoop(bench.parameters, bench.steps, bench.log.displacement, bench.bare); }

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
  const auto even = std::make_shared<Bench>(bareParameters(kElements), evenStamps(samples));
  const auto uneven = std::make_shared<Bench>(bareParameters(kElements), unevenStamps(samples));
  const std::string constant = "plain loop, constant dt";
  cases.push_back(forceCase(even, "`SampleStream::push`, constant dt", pushThrough, constant, plainLoop));
  for (const auto& [name, side] :
       {std::pair("`Component::step`", &stepThrough), std::pair("`SampleStream::push`", &pushThrough)}) {
    cases.push_back(forceCase(uneven, std::string(name) + ", every dt another", side, "plain loop, every dt its own",
                              plainLoopOfEachStep));
  }
  for (const int count : {1, 5, 10, 20}) {
    const auto bench = std::make_shared<Bench>(bareParameters(count), evenStamps(samples));
    cases.push_back(forceCase(bench, fmt::format("`Component::step`, constant dt, {} Maxwell", count), stepThrough,
                              constant, plainLoop));
  }
  cases.push_back(forceCase(even, "a log offline, `Component::simulate`", simulate, constant, plainLoop));
  cases.push_back(forceCase(even, "a log offline, `simulateLog`", simulateWholeLog, constant, plainLoop));
}

// The displacement is linear between samples for a solver, too: the error is its own. Spring and friction are added
// alike.
Case peerCase(std::size_t samples, const std::string& name, void (*solve)(const PeerWork&, std::vector<double>&)) {
  constexpr double kHighest = 1000.0;     // break frequency [Hz]; relaxes six times over within a sampling interval
  constexpr double kErrorOfPeers = 1e-2;  // a general solver is good to its own tolerance only
  const auto bench = std::make_shared<Bench>(bareParameters(kElements, kHighest), evenStamps(samples));
  const auto work = std::make_shared<PeerWork>(bench->parameters, kStep, bench->log.displacement);
  Case result = forceCase(bench, "a log with break frequencies up to 1 kHz, `Component::simulate`", simulate, name,
                          [work, solve](Bench& sides) {
                            solve(*work, sides.bare);
                            sides.bare[0] = 0.0;
                            const BareParameters& given = sides.parameters;
                            BareFriction friction{work->displacement[0], work->displacement[0]};
                            for (std::size_t i = 0; i < sides.bare.size(); ++i) {
                              const double z = work->displacement[i];
                              sides.bare[i] += given.spring * z +
                                               friction.advance(z, given.maximum_force, given.friction_displacement);
                            }
                          });
  result.tolerance = kErrorOfPeers;
  result.most_repetitions = 15;
  return result;
}

void addPeers(std::vector<Case>& cases, std::size_t samples) {
  const std::size_t most = std::min<std::size_t>(20000, samples);
  cases.push_back(peerCase(most, "Boost.odeint, Dormand-Prince", odeintDormandPrince));
#ifdef RUBBER_SUSPENSION_WITH_SIMBODY
  // It takes microseconds for a sample.
  cases.push_back(peerCase(std::min<std::size_t>(2000, samples), "Simbody, Runge-Kutta-Merson", simbodyMerson));
#endif
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
      BareParameters parameters = bareParameters(kElements);
      parameters.spring *= factor;
      parameters.maximum_force *= factor;
      for (double& stiffness : parameters.stiffness) {
        stiffness *= factor;
      }
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
  addPeers(cases, size.samples);
  return cases;
}

}  // namespace rubber_suspension::benchmark
