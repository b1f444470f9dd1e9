// Compares the latency of the node with that of an empty echo node.
#include "benchmark/latency/latency_benchmark.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>
#include <stdexcept>

#include "benchmark/latency/benchmark_node.h"

namespace rubber_suspension::benchmark {
namespace {

constexpr std::size_t kUnderWay = 100;           // samples of each component in a flood
constexpr std::uint64_t kMostInFlood = 2000000;  // more than any machine answers in some seconds
constexpr double kWarmUp = 0.5;                  // [s], before the runs that count

double medianOf(std::vector<double> values) { return summariseRatios(std::move(values)).median; }

// An echo node, and what drives it.
class Echo {
 public:
  Echo(int components, bool bundled)
      : process_(
            {ros_interface::siblingProgram("benchmark_latency"), "--echo", std::to_string(components), "__ns:=/echo"}),
        meter_("/echo", benchmarkNames(components), bundled) {
    meter_.connect();
  }

  RoundTripMeter& meter() { return meter_; }

 private:
  ros_interface::ChildProcess process_;
  RoundTripMeter meter_;
};

// Both nodes at once, each in its namespace; the one that has nothing to do sleeps. The baseline is an echo node, or,
// of a node that diagnoses, one that does not.
class Contest {
 public:
  Contest(int components, bool bundled, bool diagnose)
      : node_(components, bundled, {"node", diagnose, diagnose}),
        plain_(diagnose
                   ? std::make_unique<BenchmarkNode>(components, bundled, BenchmarkNodeOptions{"plain", true, false})
                   : nullptr),
        echo_(diagnose ? nullptr : std::make_unique<Echo>(components, bundled)) {}

  RoundTripMeter& echo() { return plain_ ? plain_->meter() : echo_->meter(); }
  RoundTripMeter& node() { return node_.meter(); }

 private:
  BenchmarkNode node_;
  std::unique_ptr<BenchmarkNode> plain_;
  std::unique_ptr<Echo> echo_;
};

void measureLatency(Contest& contest, const BenchmarkOptions& options, LatencyRow& row) {
  std::vector<double> echo_median;
  std::vector<double> echo_99;
  std::vector<double> median;
  std::vector<double> percentile_99;
  std::vector<double> again_median;
  std::vector<double> again_99;
  contest.echo().atRate(row.rate, kWarmUp);
  contest.node().atRate(row.rate, kWarmUp);
  for (int pair = 0; pair < options.pairs; ++pair) {
    // Before and after the node, so that a drift of the machine's speed favours neither.
    const RoundTrips before = contest.echo().atRate(row.rate, options.duration);
    const RoundTrips node = contest.node().atRate(row.rate, options.duration);
    const RoundTrips after = contest.echo().atRate(row.rate, options.duration);
    if (before.durations.empty() || node.durations.empty() || after.durations.empty()) {
      throw std::runtime_error("no answers in a run");
    }
    echo_median.push_back(std::sqrt(before.median() * after.median()));
    echo_99.push_back(std::sqrt(before.quantile(0.99) * after.quantile(0.99)));
    median.push_back(node.median() / echo_median.back());
    percentile_99.push_back(node.quantile(0.99) / echo_99.back());
    again_median.push_back(after.median() / before.median());
    again_99.push_back(after.quantile(0.99) / before.quantile(0.99));
    row.lost += before.lost() + node.lost() + after.lost();
  }
  row.echo_median = medianOf(echo_median);
  row.echo_99 = medianOf(echo_99);
  row.median = summariseRatios(median);
  row.percentile_99 = summariseRatios(percentile_99);
  row.again_median = summariseRatios(again_median);
  row.again_99 = summariseRatios(again_99);
}

double highestRate(RoundTripMeter& meter, double duration, int per_answer, LatencyRow& row) {
  const RoundTrips trips =
      meter.flood(duration, kUnderWay, kMostInFlood / static_cast<std::uint64_t>(row.bundled ? 1 : row.components));
  row.lost += trips.lost();
  return static_cast<double>(trips.durations.size()) * per_answer / trips.elapsed;
}

void measureHighestRate(Contest& contest, const BenchmarkOptions& options, LatencyRow& row) {
  const int per_answer = row.bundled ? row.components : 1;
  std::vector<double> echo;
  std::vector<double> node;
  for (int i = 0; i < 3; ++i) {
    echo.push_back(highestRate(contest.echo(), options.flood_duration, per_answer, row));
    node.push_back(highestRate(contest.node(), options.flood_duration, per_answer, row));
  }
  row.echo_highest = medianOf(echo);
  row.node_highest = medianOf(node);
}

LatencyRow measureRow(int components, bool bundled, const BenchmarkOptions& options) {
  LatencyRow row;
  row.components = components;
  row.bundled = bundled;
  row.diagnose = options.diagnose;
  row.rate = bundled ? options.rate : std::min(options.rate, options.total_rate / components);
  Contest contest(components, bundled, options.diagnose);
  measureLatency(contest, options, row);
  measureHighestRate(contest, options, row);
  return row;
}

}  // namespace

Ratio summariseRatios(std::vector<double> ratios) {
  std::sort(ratios.begin(), ratios.end());
  const auto at = [&](double fraction) {  // linear between the ranks
    const double rank = fraction * static_cast<double>(ratios.size() - 1);
    const auto below = static_cast<std::size_t>(rank);
    const std::size_t above = std::min(below + 1, ratios.size() - 1);
    return ratios[below] + (rank - static_cast<double>(below)) * (ratios[above] - ratios[below]);
  };
  return {at(0.5), at(0.25), at(0.75)};
}

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
  const auto show = [](const Ratio& ratio, int digits) {
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

}  // namespace rubber_suspension::benchmark
