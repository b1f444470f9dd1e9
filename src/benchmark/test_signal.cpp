// Test signals of the benchmark.
#include "benchmark/test_signal.h"

#include <cmath>
#include <random>

#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::benchmark {

std::vector<double> benchmarkDisplacement(std::size_t samples) {
  std::vector<double> displacement(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = kStep * static_cast<double>(i);
    displacement[i] = 1.0e-3 * std::sin(2.0 * element::kPi * 1.3 * t) +
                      0.8e-3 * std::sin(2.0 * element::kPi * 4.0 * t) +
                      0.2e-3 * std::sin(2.0 * element::kPi * 17.0 * t);
  }
  return displacement;
}

std::vector<std::int64_t> stampsOf(Stamps kind, std::size_t samples) {
  std::mt19937_64 random(1);
  std::vector<std::int64_t> stamps(samples);
  for (std::size_t i = 1; i < samples; ++i) {
    // Odd after even, so that no step is that before it.
    const auto jitter = static_cast<std::int64_t>(random() % 300000) * 2 + static_cast<std::int64_t>(i % 2);
    stamps[i] = stamps[i - 1] + (kind == Stamps::even ? 1000000 : 700000 + jitter);
  }
  return stamps;
}

}  // namespace rubber_suspension::benchmark
