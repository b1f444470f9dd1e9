// Fit and diagnosis of six logs of a component that hides friction, against single passes of the plain loop over them,
// half as many logs, and one thread.
#include <fmt/format.h>

#include <memory>

#include "benchmark/bare_loop.h"
#include "benchmark/cases.h"
#include "benchmark/measured_log.h"
#include "benchmark/test_signal.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::benchmark {
namespace {

// Logs of several amplitudes, and what became of diagnosing them.
struct DiagnosisBench {
  io::ComponentDescription component = describedComponent();
  std::vector<log::Log> logs;
  diagnosis::Diagnosis diagnosis;

  explicit DiagnosisBench(std::size_t samples, std::size_t count) {
    constexpr double kScales[] = {1.0, 0.3, 0.6, 0.15, 0.8, 0.45};
    for (std::size_t i = 0; i < count; ++i) {
      logs.push_back(measuredLog(fmt::format("log {}", i + 1), samples, kScales[i], static_cast<unsigned>(i) + 1));
    }
  }

  double samples() const { return static_cast<double>(logs.size() * logs.front().size()); }

  void run(int threads) {
    diagnosis::DiagnosisOptions options;
    options.threads = threads;
    diagnosis = diagnosis::diagnose(component, logs, {}, options);
  }
};

// A diagnosis against whatever else; the error is that of the diagnosis.
Case diagnosisCase(const std::shared_ptr<DiagnosisBench>& bench) {
  Case result;
  result.unit = "sample";
  result.count = bench->samples();
  result.library = [bench] { bench->run(2); };
  result.error = [bench] { return bench->diagnosis.gap.augmented - bench->diagnosis.gap.noise_floor; };
  result.error_meaning = "gap left above the noise floor";
  // The friction left out is a gap of 15 %; the fit's own share of the noise is a tenth of this.
  result.tolerance = 0.02;
  result.clock = Clock::wall;
  result.most_repetitions = 3;
  return result;
}

}  // namespace

std::vector<Case> diagnosisCases(const BenchmarkSize& size) {
  constexpr int kPasses = 100;  // so that one run is long against what interrupts it
  const auto samples = static_cast<std::size_t>(size.log_duration / kStep);
  const auto six = std::make_shared<DiagnosisBench>(samples, 6);
  const std::string name =
      fmt::format("fit and diagnosis of six logs of {:g} s at 1 kHz, 2 threads", size.log_duration);

  Case against_loop = diagnosisCase(six);
  against_loop.name = name;
  against_loop.baseline = "one pass of the plain loop, 1 Maxwell";
  against_loop.baseline_count = kPasses * six->samples();
  const auto force = std::make_shared<std::vector<double>>(samples);
  against_loop.bare = [six, force] {
    for (int i = 0; i < kPasses; ++i) {
      for (const log::Log& log : six->logs) {
        bareLoop(bareParameters(1), kStep, log.displacement, *force);
      }
    }
  };

  Case against_half = diagnosisCase(six);
  against_half.name = name;
  against_half.baseline = "the same of three of them";
  const auto three = std::make_shared<DiagnosisBench>(samples, 3);
  against_half.baseline_count = three->samples();
  against_half.bare = [three] { three->run(2); };

  Case against_one_thread = diagnosisCase(six);
  against_one_thread.name = name;
  against_one_thread.baseline = "the same in 1 thread";
  against_one_thread.baseline_count = six->samples();
  against_one_thread.bare = [six] { six->run(1); };

  // An hour and its first five minutes: of the hour the search takes excerpts, so that what grows is the reading.
  constexpr std::size_t kHour = 180;
  constexpr std::size_t kFiveMinutes = 15;
  const auto hour = std::make_shared<DiagnosisBench>(kHour * samples, 1);
  Case against_minutes = diagnosisCase(hour);
  against_minutes.name = fmt::format("fit and diagnosis of one log of {:g} s at 1 kHz, 2 threads",
                                     static_cast<double>(kHour) * size.log_duration);
  against_minutes.baseline = fmt::format("the same of {:g} s", static_cast<double>(kFiveMinutes) * size.log_duration);
  against_minutes.unit = "diagnosis";
  against_minutes.count = 1.0;
  against_minutes.baseline_count = 1.0;
  const auto minutes = std::make_shared<DiagnosisBench>(kFiveMinutes * samples, 1);
  against_minutes.bare = [minutes] { minutes->run(2); };
  return {against_loop, against_half, against_one_thread, against_minutes};
}

}  // namespace rubber_suspension::benchmark
