// A diagnosis of a log of any length.
#include "benchmark/long_log.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "benchmark/measured_log.h"
#include "benchmark/test_signal.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/log/log_source.h"

namespace rubber_suspension::benchmark {
namespace {

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
        block.stamp.push_back(static_cast<std::int64_t>(i) * 1000000);
        block.displacement.push_back(scale * motion[i % kPeriod]);
        block.force.push_back(rig.force(block.displacement.back()));
      }
      more = take(block, first);
    }
    return {};
  }

 private:
  std::size_t samples_;
};

}  // namespace

std::string diagnoseLongLog(double duration) {
  const auto samples = static_cast<std::size_t>(duration / kStep);
  const auto start = std::chrono::steady_clock::now();
  const diagnosis::Diagnosis diagnosis =
      diagnosis::diagnose(describedComponent(), log::LogSources{std::make_shared<LongLog>(samples)}, {});
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return fmt::format("{{\"samples\": {}, \"seconds\": {:.3g}, \"peak_bytes\": {}, \"verdict\": \"{}\"}}", samples,
                     seconds.count(), static_cast<long long>(usage.ru_maxrss) * 1024, toString(diagnosis.verdict));
}

}  // namespace rubber_suspension::benchmark
