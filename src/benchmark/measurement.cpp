// Pairs of runs by Google Benchmark, and their medians.
#include "benchmark/measurement.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

namespace rubber_suspension::benchmark {
namespace {

struct Pair {
  double bare;     // [s] per unit of work
  double library;  // likewise
};

double now(Clock clock) {
  if (clock == Clock::wall) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double secondsOf(const std::function<void()>& run, Clock clock) {
  const double start = now(clock);
  run();
  ::benchmark::ClobberMemory();
  return now(clock) - start;
}

Pair runPair(const Case& work, bool bare_first) {
  Pair pair{};
  if (bare_first) {
    pair.bare = secondsOf(work.bare, work.clock);
  }
  pair.library = secondsOf(work.library, work.clock);
  if (!bare_first) {
    pair.bare = secondsOf(work.bare, work.clock);
  }
  return {pair.bare / work.baseline_count, pair.library / work.count};
}

// Collects the counters of every repetition and prints nothing.
class Collector final : public ::benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type == Run::RT_Iteration) {
        pairs_.push_back({run.counters.at("bare").value, run.counters.at("library").value});
      }
    }
  }
  const std::vector<Pair>& pairs() const { return pairs_; }

 private:
  std::vector<Pair> pairs_;
};

// The value below which this part of the values lies; of two in the middle the mean.
double quantile(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  const double place = part * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - std::floor(place)) * (values[above] - values[below]);
}

std::string readable(double seconds) {
  const double magnitudes[] = {1e-9, 1e-6, 1e-3, 1.0};
  const char* const units[] = {"ns", "us", "ms", "s"};
  std::size_t i = 0;
  while (i < 3 && seconds >= magnitudes[i + 1]) {
    ++i;
  }
  return fmt::format("{:.3g} {}", seconds / magnitudes[i], units[i]);
}

std::string readableRatio(double ratio) {
  return fmt::format(ratio < 0.1 ? "{:.2g}" : ratio < 100.0 ? "{:.2f}" : "{:.0f}", ratio);
}

}  // namespace

Result measure(const Case& work, int pairs) {
  work.bare();
  work.library();
  Result result{work.name, work.baseline, work.unit,          0.0,   0.0,  0.0, 0.0,
                0.0,       work.error(),  work.error_meaning, false, false};
  result.accurate = result.error <= work.tolerance;  // false for not a number

  bool bare_first = false;
  ::benchmark::ClearRegisteredBenchmarks();
  ::benchmark::RegisterBenchmark(work.name.c_str(),
                                 [&](::benchmark::State& state) {
                                   for (auto iteration : state) {
                                     (void)iteration;
                                     bare_first = !bare_first;
                                     const Pair pair = runPair(work, bare_first);
                                     state.counters["bare"] = pair.bare;
                                     state.counters["library"] = pair.library;
                                     state.SetIterationTime(pair.library);
                                   }
                                 })
      ->UseManualTime()
      ->Iterations(1)
      ->Repetitions(std::min(pairs, work.most_repetitions));
  Collector collector;
  ::benchmark::RunSpecifiedBenchmarks(&collector);

  std::vector<double> bare;
  std::vector<double> library;
  std::vector<double> ratio;
  for (const Pair& pair : collector.pairs()) {
    bare.push_back(pair.bare);
    library.push_back(pair.library);
    ratio.push_back(pair.library / pair.bare);
  }
  result.bare = quantile(bare, 0.5);
  result.library = quantile(library, 0.5);
  result.ratio = quantile(ratio, 0.5);
  result.lowest = quantile(ratio, 0.25);
  result.highest = quantile(ratio, 0.75);
  constexpr std::size_t kFewest = 15;  // pairs; fewer only show that the case runs
  result.slow = ratio.size() >= kFewest && result.lowest > work.most;
  return result;
}

std::string markdown(const std::vector<Result>& results) {
  std::string text =
      "| work of the library | compared with | ratio (quartiles) | library | compared | error |\n"
      "|---|---|---|---|---|---|\n";
  for (const Result& row : results) {
    text += fmt::format("| {} | {} | **{}** ({} to {}) | {} per {} | {} | {:.1e} {} |\n", row.name, row.baseline,
                        readableRatio(row.ratio), readableRatio(row.lowest), readableRatio(row.highest),
                        readable(row.library), row.unit, readable(row.bare), row.error, row.error_meaning);
  }
  return text;
}

}  // namespace rubber_suspension::benchmark
