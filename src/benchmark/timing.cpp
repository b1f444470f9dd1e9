// Times of repeated work.
#include "benchmark/timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "numerics/quantile.h"

namespace rubber_suspension::benchmark {
namespace {

double now(Clock clock) {
  timespec time{};
  clock_gettime(clock == Clock::wall ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

double secondsOf(const std::function<void()>& run, Clock clock) {
  const double start = now(clock);
  run();
  return now(clock) - start;
}

io::Spread spreadOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {numerics::quantileOf(values, 0.5), numerics::quantileOf(values, 0.25), numerics::quantileOf(values, 0.75)};
}

std::string readable(double seconds) {
  const std::pair<double, const char*> units[] = {{1.0, "s"}, {1e-3, "ms"}, {1e-6, "us"}, {1e-9, "ns"}};
  const auto* unit = std::find_if(units, units + 3, [&](const auto& one) { return seconds >= one.first; });
  return fmt::format("{:.3g} {}", seconds / unit->first, unit->second);
}

}  // namespace rubber_suspension::benchmark
