// Compares the latency of the node with that of an echo node without components.
#include "benchmark/latency/latency_benchmark.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>

#include "benchmark/latency/benchmark_node.h"
#include "benchmark/timing.h"
#include "element/refuse.h"

namespace rubber_suspension::benchmark {
namespace {

constexpr std::size_t kUnderWay = 100;           // unanswered samples of each component in a flood
constexpr std::uint64_t kMostInFlood = 2000000;  // more samples than any computer answers in a flood
constexpr double kWarmUp = 0.5;                  // time before the measured runs [s]

using Runs = std::array<RoundTrips, 3>;  // runs of the echo node, of the node, and of the echo node again

LatencyQuantile quantileOf(const std::vector<Runs>& all, double fraction) {
  std::vector<double> echo;
  std::vector<double> node;
  std::vector<double> again;
  for (const auto& [before, trips, after] : all) {
    echo.push_back(std::sqrt(before.quantile(fraction) * after.quantile(fraction)));
    node.push_back(trips.quantile(fraction) / echo.back());
    again.push_back(after.quantile(fraction) / before.quantile(fraction));
  }
  return {spreadOf(echo).median, spreadOf(node), spreadOf(again)};
}

// Both nodes run all the time in their namespaces. The node that is not measured is idle.
void measureLatency(RoundTripMeter& echo, RoundTripMeter& node, const BenchmarkOptions& options, LatencyRow& row) {
  std::vector<Runs> all;
  echo.atRate(row.rate, kWarmUp);
  node.atRate(row.rate, kWarmUp);
  for (int pair = 0; pair < options.pairs; ++pair) {
    // The echo node runs before and after the node, so a drift in the speed of the computer favours neither.
    all.push_back({echo.atRate(row.rate, options.duration), node.atRate(row.rate, options.duration),
                   echo.atRate(row.rate, options.duration)});
    for (const RoundTrips& trips : all.back()) {
      element::refuseIf<std::runtime_error>(trips.durations.empty(), "no answers in a run");
      row.lost += trips.lost();
    }
  }
  row.median = quantileOf(all, 0.5);
  row.late = quantileOf(all, 0.99);
}

double highestRate(RoundTripMeter& meter, double duration, LatencyRow& row) {
  const int links = row.bundled ? 1 : row.components;
  const RoundTrips trips = meter.flood(duration, kUnderWay, kMostInFlood / static_cast<std::uint64_t>(links));
  row.lost += trips.lost();
  return static_cast<double>(trips.durations.size()) * row.components / links / trips.elapsed;
}

LatencyRow measureRow(int components, bool bundled, const BenchmarkOptions& options) {
  LatencyRow row;
  row.components = components;
  row.bundled = bundled;
  row.diagnose = options.diagnose;
  row.rate = bundled ? options.rate : std::min(options.rate, options.total_rate / components);
  // The baseline is an echo node. If the node diagnoses, the baseline is a node without the diagnosis.
  BenchmarkNode node(row.diagnose ? NodeKind::diagnosing : NodeKind::plain, components, bundled, row.diagnose);
  BenchmarkNode echo(row.diagnose ? NodeKind::plain : NodeKind::echo, components, bundled, row.diagnose);
  measureLatency(echo.meter(), node.meter(), options, row);
  std::vector<double> echo_highest;
  std::vector<double> node_highest;
  for (int i = 0; i < 3; ++i) {
    echo_highest.push_back(highestRate(echo.meter(), options.flood_duration, row));
    node_highest.push_back(highestRate(node.meter(), options.flood_duration, row));
  }
  row.echo_highest = spreadOf(echo_highest).median;
  row.node_highest = spreadOf(node_highest).median;
  return row;
}

}  // namespace

std::vector<LatencyRow> benchmarkLatency(const BenchmarkOptions& options,
                                         const std::function<void(const std::string&)>& progress) {
  std::vector<LatencyRow> rows;
  for (const int components : options.components) {
    progress(fmt::format("{} component(s), a topic each", components));
    rows.push_back(measureRow(components, false, options));
  }
  if (options.diagnose) {
    return rows;  // bundles use the same code, and have no topic for measured forces
  }
  const int most = *std::max_element(options.components.begin(), options.components.end());
  progress(fmt::format("{} component(s) in one message", most));
  rows.push_back(measureRow(most, true, options));
  return rows;
}

void printMarkdown(const std::vector<LatencyRow>& rows, std::ostream& out) {
  const auto show = [](const io::Spread& ratio, int digits) {
    return fmt::format("**{:.{}f}** ({:.{}f} to {:.{}f})", ratio.median, digits, ratio.lower, digits, ratio.upper,
                       digits);
  };
  const bool diagnose = !rows.empty() && rows.front().diagnose;
  const std::string base = diagnose ? "plain" : "echo";
  const std::string node = diagnose ? "diagnosing" : "node";
  out << fmt::format(
      "| components | rate of each [Hz] | {0}: median, 99 % [us] | {1}/{0}, median | {0}/{0}, median | {1}/{0}, 99 % | "
      "{0}/{0}, 99 % | without answer | highest rate, {0} [samples/s] | highest rate, {1} |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n",
      base, node);
  for (const LatencyRow& row : rows) {
    out << fmt::format("| {}{} | {:.0f} | {:.0f}, {:.0f} | {} | {} | {} | {} | {} | {:.0f} | {:.0f} |\n",
                       row.components, row.bundled ? " in one message" : "", row.rate, 1e6 * row.median.echo,
                       1e6 * row.late.echo, show(row.median.node, 3), show(row.median.again, 3), show(row.late.node, 2),
                       show(row.late.again, 2), row.lost, row.echo_highest, row.node_highest);
  }
}

}  // namespace rubber_suspension::benchmark
