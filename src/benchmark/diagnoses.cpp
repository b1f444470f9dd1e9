// Benchmarks of the diagnosis of six logs, and of one log of any length. The description of the test piece lacks
// friction.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>

#include "benchmark/example.h"
#include "benchmark/own_work.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/log/log_source.h"

namespace rubber_suspension::benchmark {
namespace {

io::ComponentDescription describedComponent() {
  return {"benchmark",
          {{"spring", {{"stiffness", {3.0e6}}}}, {"maxwell", {{"stiffness", {1.3e6}}, {"break_frequency", {1.43}}}}}};
}

// Returns the described component with additional friction, whose minor loops close as in rubber.
component::Component testPiece() {
  std::vector<element::ElementDescription> elements = describedComponent().elements();
  elements.push_back({"iwan", {{"maximum_force", {3000.0}}, {"displacement", {5e-4}}}});
  return component::Component(elements);
}

// Measures the test piece with noise on the force, which is the same with every compiler.
class MeasuringRig {
 public:
  explicit MeasuringRig(unsigned seed) : random_(seed) {}

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

std::vector<log::Log> sixLogs(double duration) {
  std::vector<log::Log> logs;
  for (const double scale : {1.0, 0.3, 0.6, 0.15, 0.8, 0.45}) {
    logs.emplace_back().name = fmt::format("log {}", logs.size());
    MeasuringRig rig(static_cast<unsigned>(logs.size()));
    for (const double z : benchmarkDisplacement(static_cast<std::size_t>(duration / kStep))) {
      rig.measure(scale * z, logs.back());
    }
  }
  return logs;
}

// A log that repeats the motion of the benchmark with an amplitude that changes over minutes.
class LongLog : public log::LogSource {
 public:
  explicit LongLog(std::size_t samples) : samples_(samples) {}

  std::string name() const override { return "long log"; }

  std::vector<std::string> read(const Take& take) const override {
    constexpr std::size_t kPeriod = 10000;  // common period of 1.3, 4 and 17 Hz [samples]
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

std::vector<Work> diagnoses(double duration) {
  std::vector<Work> all;
  const auto logs = std::make_shared<std::vector<log::Log>>(sixLogs(duration));
  for (const int threads : {1, 2}) {
    const auto run = [logs, threads] {
      diagnosis::DiagnosisOptions options;
      options.threads = threads;
      diagnosis::diagnose(describedComponent(), *logs, {}, options);
    };
    const std::string name = fmt::format("diagnosis of six logs of {:g} s at 1 kHz, {}", duration,
                                         threads == 1 ? "one thread" : "two threads");
    all.push_back({name, "sample", static_cast<double>(logs->size() * logs->front().size()), run, Clock::wall});
  }
  return all;
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
                     seconds, static_cast<long long>(usage.ru_maxrss) * 1024, toString(diagnosis.answer.verdict));
}

}  // namespace rubber_suspension::benchmark
