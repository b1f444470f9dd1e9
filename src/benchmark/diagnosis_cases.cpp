// Fit and diagnosis of logs of a component that hides friction: six logs against single passes of the plain loop over
// them, and against one thread; and one log of any length.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>

#include "benchmark/bare_loop.h"
#include "benchmark/cases.h"
#include "benchmark/test_signal.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/log/log_source.h"

namespace rubber_suspension::benchmark {
namespace {

io::ComponentDescription describedComponent() {
  return {"benchmark",
          {{"spring", {{"stiffness", {3.0e6}}}}, {"maxwell", {{"stiffness", {1.3e6}}, {"break_frequency", {1.43}}}}}};
}

// The test piece has friction on top, which has memory, as rubber's: minor loops close.
component::Component testPiece() {
  std::vector<element::ElementDescription> elements = describedComponent().elements();
  elements.push_back({"iwan", {{"maximum_force", {3000.0}}, {"displacement", {5e-4}}}});
  return component::Component(elements);
}

// The test piece with noise of the force, the same with every compiler.
class MeasuringRig {
 public:
  explicit MeasuringRig(unsigned seed) : random_(seed) {}

  // The sample a step later, at the next displacement [m].
  void measure(double displacement, log::Log& log) {
    log.stamp.push_back(1000000 * next_++);
    log.displacement.push_back(displacement);
    log.force.push_back(test_piece_.step(state_, kStep, displacement).total + noise_(random_));
  }

 private:
  const component::Component test_piece_ = testPiece();
  component::ComponentState state_ = test_piece_.makeState();
  boost::random::mt19937_64 random_;
  boost::random::normal_distribution<> noise_{0.0, 50.0};  // [N]
  std::int64_t next_ = 0;
};

// Logs of several amplitudes, and what became of diagnosing them.
struct DiagnosisBench {
  std::vector<log::Log> logs;
  diagnosis::Diagnosis diagnosis;

  explicit DiagnosisBench(std::size_t samples, std::size_t count) {
    constexpr double kScales[] = {1.0, 0.3, 0.6, 0.15, 0.8, 0.45};
    for (std::size_t i = 0; i < count; ++i) {
      MeasuringRig rig(static_cast<unsigned>(i) + 1);
      logs.emplace_back().name = fmt::format("log {}", i + 1);
      for (const double z : benchmarkDisplacement(samples)) {
        rig.measure(kScales[i] * z, logs.back());
      }
    }
  }

  double samples() const { return static_cast<double>(logs.size() * logs.front().size()); }

  void run(int threads) {
    diagnosis::DiagnosisOptions options;
    options.threads = threads;
    diagnosis = diagnosis::diagnose(describedComponent(), logs, {}, options);
  }
};

// A diagnosis against whatever else; the error is that of the diagnosis.
template <class Bare>
Case diagnosisCase(const std::shared_ptr<DiagnosisBench>& bench, const std::string& name, const std::string& baseline,
                   Bare bare) {
  const auto run = [](DiagnosisBench& work) { work.run(2); };
  Case result = caseOf(bench, "fit and diagnosis of " + name + " at 1 kHz, 2 threads", run, baseline, bare, "sample",
                       bench->samples());
  result.error = [bench] { return bench->diagnosis.gap.augmented - bench->diagnosis.gap.noise_floor; };
  result.error_meaning = "gap left above the noise floor";
  // The friction left out is a gap of 15 %; the fit's own share of the noise is a tenth of this.
  result.tolerance = 0.02;
  result.clock = Clock::wall;
  result.most_repetitions = 3;
  return result;
}

// The benchmark's motion again and again, with an amplitude that changes over minutes.
class LongLog : public log::LogSource {
 public:
  explicit LongLog(std::size_t samples) : samples_(samples) {}

  std::string name() const override { return "long log"; }

  std::vector<std::string> read(const Take& take) const override {
    constexpr std::size_t kPeriod = 10000;  // of 1.3, 4 and 17 Hz together
    constexpr double kSlowly = 2.0 * element::kPi / 900e3;
    const std::vector<double> motion = benchmarkDisplacement(kPeriod);
    MeasuringRig rig(1);
    bool more = true;
    for (std::size_t first = 0; more && first < samples_; first += log::kLogBlock) {
      log::Log block;
      block.name = name();
      for (std::size_t i = first; i < std::min(first + log::kLogBlock, samples_); ++i) {
        const double scale = 0.55 + 0.45 * std::sin(kSlowly * static_cast<double>(i));
        rig.measure(scale * motion[i % kPeriod], block);
      }
      more = take(block, first);
    }
    return {};
  }

 private:
  std::size_t samples_;
};

}  // namespace

std::vector<Case> diagnosisCases(const BenchmarkSize& size) {
  constexpr int kPasses = 100;  // so that one run is long against what interrupts it
  const auto six = std::make_shared<DiagnosisBench>(static_cast<std::size_t>(size.log_duration / kStep), 6);
  const std::string name = fmt::format("six logs of {:g} s", size.log_duration);
  const auto passes = [force = std::vector<double>(six->logs.front().size())](const DiagnosisBench& work) mutable {
    for (int i = 0; i < kPasses; ++i) {
      for (const log::Log& log : work.logs) {
        bareLoop(bareParameters(1), {kStep}, log.displacement, force);
      }
    }
  };
  std::vector<Case> cases = {
      diagnosisCase(six, name, "one pass of the plain loop, 1 Maxwell", passes),
      diagnosisCase(six, name, "the same in 1 thread", [](DiagnosisBench& work) { work.run(1); })};
  cases[0].baseline_count *= kPasses;
  return cases;
}

std::string diagnoseLongLog(double duration) {
  const auto samples = static_cast<std::size_t>(duration / kStep);
  diagnosis::Diagnosis diagnosis;
  const auto diagnose = [&] {
    diagnosis = diagnosis::diagnose(describedComponent(), log::LogSources{std::make_shared<LongLog>(samples)}, {});
  };
  const double seconds = secondsOf(diagnose, Clock::wall);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return fmt::format("{{\"samples\": {}, \"seconds\": {:.3g}, \"peak_bytes\": {}, \"verdict\": \"{}\"}}", samples,
                     seconds, static_cast<long long>(usage.ru_maxrss) * 1024, toString(diagnosis.verdict));
}

}  // namespace rubber_suspension::benchmark
