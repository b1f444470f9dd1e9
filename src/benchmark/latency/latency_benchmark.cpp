// Compares the latency of the node with that of an empty echo node.
#include "benchmark/latency/latency_benchmark.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <stdexcept>

#include "benchmark/latency/benchmark_node.h"
#include "benchmark/spread.h"
#include "element/refuse.h"

namespace rubber_suspension::benchmark {
namespace {

constexpr std::size_t kUnderWay = 100;           // samples of each component in a flood
constexpr std::uint64_t kMostInFlood = 2000000;  // more than any machine answers in some seconds
constexpr double kWarmUp = 0.5;                  // [s], before the runs that count

double medianOf(std::vector<double> values) { return spreadOf(std::move(values)).median; }

// A quantile of the round trips in runs of echo node, node and echo node again.
struct Quantile {
  double fraction;
  std::vector<double> echo = {};
  std::vector<double> node = {};   // over that of the echo node
  std::vector<double> again = {};  // of the echo node over itself

  void add(const RoundTrips& before, const RoundTrips& trips, const RoundTrips& after) {
    echo.push_back(std::sqrt(before.quantile(fraction) * after.quantile(fraction)));
    node.push_back(trips.quantile(fraction) / echo.back());
    again.push_back(after.quantile(fraction) / before.quantile(fraction));
  }
};

// Both nodes run at once, each in its namespace; the one that has nothing to do sleeps.
void measureLatency(RoundTripMeter& echo, RoundTripMeter& node, const BenchmarkOptions& options, LatencyRow& row) {
  Quantile median{0.5};
  Quantile late{0.99};
  echo.atRate(row.rate, kWarmUp);
  node.atRate(row.rate, kWarmUp);
  for (int pair = 0; pair < options.pairs; ++pair) {
    // Before and after the node, so that a drift of the machine's speed favours neither.
    const RoundTrips before = echo.atRate(row.rate, options.duration);
    const RoundTrips trips = node.atRate(row.rate, options.duration);
    const RoundTrips after = echo.atRate(row.rate, options.duration);
    element::refuseIf<std::runtime_error>(
        before.durations.empty() || trips.durations.empty() || after.durations.empty(), "no answers in a run");
    median.add(before, trips, after);
    late.add(before, trips, after);
    row.lost += before.lost() + trips.lost() + after.lost();
  }
  row.echo_median = medianOf(median.echo);
  row.echo_99 = medianOf(late.echo);
  row.median = spreadOf(median.node);
  row.percentile_99 = spreadOf(late.node);
  row.again_median = spreadOf(median.again);
  row.again_99 = spreadOf(late.again);
}

double highestRate(RoundTripMeter& meter, double duration, int per_answer, LatencyRow& row) {
  const RoundTrips trips =
      meter.flood(duration, kUnderWay, kMostInFlood / static_cast<std::uint64_t>(row.bundled ? 1 : row.components));
  row.lost += trips.lost();
  return static_cast<double>(trips.durations.size()) * per_answer / trips.elapsed;
}

LatencyRow measureRow(int components, bool bundled, const BenchmarkOptions& options) {
  LatencyRow row;
  row.components = components;
  row.bundled = bundled;
  row.diagnose = options.diagnose;
  row.rate = bundled ? options.rate : std::min(options.rate, options.total_rate / components);
  // The baseline is an echo node or, of a node that diagnoses, one that does not.
  BenchmarkNode node(row.diagnose ? NodeKind::diagnosing : NodeKind::plain, components, bundled, row.diagnose);
  BenchmarkNode echo(row.diagnose ? NodeKind::plain : NodeKind::echo, components, bundled, row.diagnose);
  measureLatency(echo.meter(), node.meter(), options, row);
  const int per_answer = bundled ? components : 1;
  std::vector<double> echo_highest;
  std::vector<double> node_highest;
  for (int i = 0; i < 3; ++i) {
    echo_highest.push_back(highestRate(echo.meter(), options.flood_duration, per_answer, row));
    node_highest.push_back(highestRate(node.meter(), options.flood_duration, per_answer, row));
  }
  row.echo_highest = medianOf(echo_highest);
  row.node_highest = medianOf(node_highest);
  return row;
}

// What axes of the figure show of each row.
struct Series {
  std::string label;
  std::function<io::Spread(const LatencyRow&)> value;
};

io::Axes axesOf(const std::vector<LatencyRow>& rows, const std::string& x_label, const std::vector<Series>& all) {
  io::Axes axes{"", x_label, ""};
  for (const LatencyRow& row : rows) {
    axes.rows.push_back(fmt::format("{} component{}\n{:.0f} Hz{}", row.components, row.components == 1 ? "" : "s",
                                    row.rate, row.bundled ? ", one message" : ""));
  }
  constexpr double kOffsets[] = {-0.14, 0.14};  // of two values of one row, from its middle
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::vector<io::Spread> values(rows.size());
    std::transform(rows.begin(), rows.end(), values.begin(), all[i].value);
    io::addSpreads(axes, all[i].label, values, kOffsets[i], static_cast<int>(i));
  }
  return axes;
}

io::Axes ratioAxes(const std::vector<LatencyRow>& rows, const std::string& of, io::Spread LatencyRow::*node,
                   io::Spread LatencyRow::*again) {
  io::Axes axes = axesOf(rows, "ratio of the " + of + " [-]", {{"node / echo", node}, {"echo / itself", again}});
  axes.curves.push_back({"", {1.0, 1.0}, {-0.5, static_cast<double>(rows.size()) - 0.5}, ":", 7});
  return axes;
}

// Of values without quartiles.
io::Axes valueAxes(const std::vector<LatencyRow>& rows, const std::string& x_label, double factor,
                   const std::vector<std::pair<std::string, double LatencyRow::*>>& all) {
  std::vector<Series> series;
  for (const auto& [label, member] : all) {
    series.push_back({label, [factor, value = member](const LatencyRow& row) {
                        return io::Spread{factor * row.*value, factor * row.*value, factor * row.*value};
                      }});
  }
  io::Axes axes = axesOf(rows, x_label, series);
  axes.log_x = true;
  return axes;
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
    return rows;  // what is bundled takes the same way, and has no topic for measured forces
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
                       row.components, row.bundled ? " in one message" : "", row.rate, 1e6 * row.echo_median,
                       1e6 * row.echo_99, show(row.median, 3), show(row.again_median, 3), show(row.percentile_99, 2),
                       show(row.again_99, 2), row.lost, row.echo_highest, row.node_highest);
  }
}

io::Figure latencyFigure(const std::vector<LatencyRow>& rows) {
  return {"Round trips through the node and an empty echo node",
          {ratioAxes(rows, "medians", &LatencyRow::median, &LatencyRow::again_median),
           ratioAxes(rows, "99th percentiles", &LatencyRow::percentile_99, &LatencyRow::again_99),
           valueAxes(rows, "round trip through the echo node [ms]", 1e3,
                     {{"median", &LatencyRow::echo_median}, {"99 %", &LatencyRow::echo_99}}),
           valueAxes(rows, "highest rate, all components [1000 samples/s]", 1e-3,
                     {{"node", &LatencyRow::node_highest}, {"echo", &LatencyRow::echo_highest}})},
          2};
}

}  // namespace rubber_suspension::benchmark
