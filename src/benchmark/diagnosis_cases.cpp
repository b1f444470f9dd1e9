// Fit and diagnosis of two logs of a component that hides friction, against single passes of the plain loop over them.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <random>

#include "bare_loop.h"
#include "cases.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "test_signal.h"

namespace rubber_suspension {
namespace {

constexpr double kNoise = 50.0;  // standard deviation of the measured force's noise [N]; the friction is 3 kN

// A component with one Maxwell element; the specimen has friction on top, which the description lacks. It is friction
// with memory, as rubber's: its minor loops close.
ComponentDescription description() {
  ComponentDescription component;
  component.name = "benchmark";
  component.elements = {{"spring", {{"stiffness", {3.0e6}}}},
                        {"maxwell", {{"stiffness", {1.3e6}}, {"break_frequency", {1.43}}}}};
  return component;
}

Log measuredLog(const std::string& name, std::size_t samples, double scale, unsigned seed) {
  std::vector<ElementDescription> elements = description().elements;
  elements.push_back({"iwan", {{"maximum_force", {3000.0}}, {"displacement", {5e-4}}}});
  const Component specimen(elements);
  ComponentState state = specimen.makeState();
  std::mt19937_64 random(seed);
  Log log;
  log.name = name;
  log.stamp = evenStamps(samples);
  log.displacement = benchmarkDisplacement(samples);
  for (double& z : log.displacement) {
    z *= scale;
    double noise = 0.0;  // twelve uniform numbers make a normal one, the same with every compiler
    for (int i = 0; i < 12; ++i) {
      noise += static_cast<double>(random() >> 11) * 0x1p-53;
    }
    log.force.push_back(specimen.step(state, kStep, z).total + kNoise * (noise - 6.0));
  }
  return log;
}

}  // namespace

std::vector<Case> diagnosisCases(const BenchmarkSize& size) {
  struct Bench {
    ComponentDescription component = description();
    BareParameters parameters = bareParameters(1);
    std::vector<Log> logs;
    std::vector<double> bare;
    Diagnosis library;
  };
  const auto samples = static_cast<std::size_t>(size.log_duration / kStep);
  const auto bench = std::make_shared<Bench>();
  bench->logs = {measuredLog("large", samples, 1.0, 1), measuredLog("small", samples, 0.3, 2)};
  bench->bare.resize(samples);
  constexpr int kPasses = 100;  // so that one run is long against what interrupts it
  Case result;
  result.name = fmt::format("fit and diagnosis of two logs of {:g} s at 1 kHz, 2 threads", size.log_duration);
  result.yardstick = "one pass of the plain loop, 1 Maxwell";
  result.unit = "sample";
  result.count = 2.0 * static_cast<double>(samples);
  result.yardstick_count = kPasses * result.count;
  result.bare = [bench] {
    for (int i = 0; i < kPasses; ++i) {
      for (const Log& log : bench->logs) {
        bareLoop(bench->parameters, kStep, log.displacement, bench->bare);
      }
    }
  };
  result.library = [bench] { bench->library = diagnose(bench->component, bench->logs, {}); };
  result.error = [bench] { return bench->library.gap.augmented - bench->library.gap.noise_floor; };
  result.error_meaning = "gap left above the noise floor";
  // The friction left out is a gap of 15 %; the fit's own share of the noise is a tenth of this.
  result.tolerance = 0.02;
  result.clock = Clock::wall;
  result.most_repetitions = 3;
  return {result};
}

}  // namespace rubber_suspension
