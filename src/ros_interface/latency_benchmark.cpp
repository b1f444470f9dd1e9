// Compares the latency of the node with that of an empty echo node.
#include "rubber_suspension/ros_interface/latency_benchmark.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <stdexcept>

#include "rubber_suspension/ros_interface/child_process.h"
#include "rubber_suspension/ros_interface/round_trip.h"

namespace rubber_suspension {
namespace {

constexpr std::size_t kUnderWay = 100;  // samples of each component in a flood
constexpr double kWarmUp = 0.5;         // [s], before the runs that count

double medianOf(std::vector<double> values) { return summariseRatios(std::move(values)).median; }

// A file that goes with this object.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text)
      : path_(std::filesystem::temp_directory_path() / fmt::format("rubber_suspension_benchmark_{}.yaml", getpid())) {
    std::ofstream file(path_);
    file << text;
    if (!file.flush()) {
      throw std::runtime_error(path_.string() + " cannot be written");
    }
  }
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

// Both nodes at once, each in its namespace; the one that has nothing to do sleeps.
class Contest {
 public:
  Contest(int components, bool bundled)
      : file_(benchmarkComponents(components)),
        echo_process_({siblingProgram("benchmark_latency"), "--echo", std::to_string(components), "__ns:=/echo"}),
        node_process_({siblingProgram("simulate"), "__ns:=/node", "_config_file:=" + file_.path()}),
        echo_("/echo", benchmarkNames(components), bundled),
        node_("/node", benchmarkNames(components), bundled) {
    echo_.connect();
    node_.connect();
  }

  RoundTripMeter& echo() { return echo_; }
  RoundTripMeter& node() { return node_; }

 private:
  TemporaryFile file_;
  ChildProcess echo_process_;
  ChildProcess node_process_;
  RoundTripMeter echo_;
  RoundTripMeter node_;
};

void measureLatency(Contest& contest, const BenchmarkOptions& options, LatencyRow& row) {
  std::vector<double> echo_median;
  std::vector<double> echo_99;
  std::vector<double> median;
  std::vector<double> percentile_99;
  contest.echo().atRate(row.rate, kWarmUp);
  contest.node().atRate(row.rate, kWarmUp);
  for (int pair = 0; pair < options.pairs; ++pair) {
    // Which comes first changes from pair to pair, so that a drift of the machine's speed favours neither.
    const bool echo_first = pair % 2 == 0;
    const RoundTrips first = (echo_first ? contest.echo() : contest.node()).atRate(row.rate, options.duration);
    const RoundTrips second = (echo_first ? contest.node() : contest.echo()).atRate(row.rate, options.duration);
    const RoundTrips& echo = echo_first ? first : second;
    const RoundTrips& node = echo_first ? second : first;
    if (echo.durations.empty() || node.durations.empty()) {
      throw std::runtime_error("no answers in a run");
    }
    echo_median.push_back(echo.median());
    echo_99.push_back(echo.quantile(0.99));
    median.push_back(node.median() / echo.median());
    percentile_99.push_back(node.quantile(0.99) / echo.quantile(0.99));
    row.lost += echo.lost() + node.lost();
  }
  row.echo_median = medianOf(echo_median);
  row.echo_99 = medianOf(echo_99);
  row.median = summariseRatios(median);
  row.percentile_99 = summariseRatios(percentile_99);
}

double highestRate(RoundTripMeter& meter, double duration, int per_answer, LatencyRow& row) {
  const RoundTrips trips = meter.flood(duration, kUnderWay);
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
  row.rate = bundled ? options.rate : std::min(options.rate, options.total_rate / components);
  Contest contest(components, bundled);
  measureLatency(contest, options, row);
  measureHighestRate(contest, options, row);
  return row;
}

}  // namespace

Ratio summariseRatios(std::vector<double> ratios) {
  std::sort(ratios.begin(), ratios.end());
  const std::size_t middle = ratios.size() / 2;
  const double median = ratios.size() % 2 == 1 ? ratios[middle] : 0.5 * (ratios[middle - 1] + ratios[middle]);
  return {median, ratios.front(), ratios.back()};
}

std::vector<std::string> benchmarkNames(int count) {
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) {
    names.push_back(fmt::format("component_{:03d}", i));
  }
  return names;
}

std::string benchmarkComponents(int count) {
  std::string text = "components:\n";
  int i = 0;
  for (const std::string& name : benchmarkNames(count)) {
    const bool berg = i++ % 2 == 1;
    text += fmt::format(
        "  {}:\n    model: {}\n    specification: {{static_stiffness: 3.0e6, dynamic_stiffness: 4.2e6, "
        "nominal_frequency: 4.0, {}}}\n",
        name, berg ? "berg" : "multi_maxwell",
        berg ? "nominal_amplitude: 0.002, loss_angle: 0.0995, break_frequency: 1.45"
             : "maximum_stiffness: 4.9e6, high_frequency: 25.0");
  }
  return text;
}

std::vector<LatencyRow> benchmarkLatency(const BenchmarkOptions& options,
                                         const std::function<void(const std::string&)>& progress) {
  std::vector<LatencyRow> rows;
  for (const int components : options.components) {
    progress(fmt::format("{} component(s), a topic each", components));
    rows.push_back(measureRow(components, false, options));
  }
  const int most = *std::max_element(options.components.begin(), options.components.end());
  progress(fmt::format("{} component(s) in one message", most));
  rows.push_back(measureRow(most, true, options));
  return rows;
}

void printMarkdown(const std::vector<LatencyRow>& rows, std::ostream& out) {
  out << "| components | rate of each [Hz] | echo: median, 99 % [us] | node/echo, median | node/echo, 99 % | without "
         "answer | highest rate, echo [samples/s] | highest rate, node |\n"
         "|---|---|---|---|---|---|---|---|\n";
  for (const LatencyRow& row : rows) {
    out << fmt::format(
        "| {}{} | {:.0f} | {:.0f}, {:.0f} | {:.3f} ({:.3f} to {:.3f}) | {:.2f} ({:.2f} to {:.2f}) | {} | "
        "{:.0f} | {:.0f} |\n",
        row.components, row.bundled ? " in one message" : "", row.rate, 1e6 * row.echo_median, 1e6 * row.echo_99,
        row.median.median, row.median.lowest, row.median.highest, row.percentile_99.median, row.percentile_99.lowest,
        row.percentile_99.highest, row.lost, row.echo_highest, row.node_highest);
  }
}

}  // namespace rubber_suspension
