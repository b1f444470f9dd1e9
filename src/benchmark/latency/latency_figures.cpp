// The tables of the command `benchmark_latency` as figures.
#include "benchmark/latency/latency_figures.h"

#include <fmt/format.h>

namespace rubber_suspension::benchmark {
namespace {

constexpr double kOffset = 0.14;  // of two values of one row, from its middle
constexpr int kNode = 0;          // indices into the palette
constexpr int kEcho = 1;

io::Axes emptyAxes(const std::vector<LatencyRow>& rows, const std::string& x_label) {
  io::Axes axes;
  axes.x_label = x_label;
  for (const LatencyRow& row : rows) {
    axes.rows.push_back(fmt::format("{} component{}\n{:.0f} Hz{}", row.components, row.components == 1 ? "" : "s",
                                    row.rate, row.bundled ? ", one message" : ""));
  }
  return axes;
}

io::Axes ratioAxes(const std::vector<LatencyRow>& rows, const std::string& of, Ratio LatencyRow::*node,
                   Ratio LatencyRow::*again) {
  io::Axes axes = emptyAxes(rows, "ratio of the " + of + " [-]");
  std::vector<io::Spread> to_echo;
  std::vector<io::Spread> to_itself;
  for (const LatencyRow& row : rows) {
    to_echo.push_back({(row.*node).median, (row.*node).lower, (row.*node).upper});
    to_itself.push_back({(row.*again).median, (row.*again).lower, (row.*again).upper});
  }
  axes.curves.push_back({"", {1.0, 1.0}, {-0.5, static_cast<double>(rows.size()) - 0.5}, ":", 7});
  io::addSpreads(axes, "node / echo", to_echo, -kOffset, kNode);
  io::addSpreads(axes, "echo / itself", to_itself, kOffset, kEcho);
  return axes;
}

// Values without quartiles, one curve of markers.
void addValues(io::Axes& axes, const std::string& label, const std::vector<LatencyRow>& rows, double LatencyRow::*value,
               double factor, double offset, const std::string& style, int colour) {
  io::Curve curve{label, {}, {}, style, colour};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    curve.x.push_back(factor * rows[i].*value);
    curve.y.push_back(static_cast<double>(i) + offset);
  }
  axes.curves.push_back(std::move(curve));
}

io::Axes roundTripAxes(const std::vector<LatencyRow>& rows) {
  io::Axes axes = emptyAxes(rows, "round trip through the echo node [ms]");
  axes.log_x = true;
  addValues(axes, "median", rows, &LatencyRow::echo_median, 1e3, 0.0, "o", kEcho);
  addValues(axes, "99 %", rows, &LatencyRow::echo_99, 1e3, 0.0, "D", kEcho);
  return axes;
}

io::Axes highestRateAxes(const std::vector<LatencyRow>& rows) {
  io::Axes axes = emptyAxes(rows, "highest rate, all components [1000 samples/s]");
  axes.log_x = true;
  addValues(axes, "node", rows, &LatencyRow::node_highest, 1e-3, -kOffset, "o", kNode);
  addValues(axes, "echo", rows, &LatencyRow::echo_highest, 1e-3, kOffset, "o", kEcho);
  return axes;
}

}  // namespace

io::Figure latencyFigure(const std::vector<LatencyRow>& rows) {
  return {"Round trips through the node and an empty echo node",
          {ratioAxes(rows, "medians", &LatencyRow::median, &LatencyRow::again_median),
           ratioAxes(rows, "99th percentiles", &LatencyRow::percentile_99, &LatencyRow::again_99), roundTripAxes(rows),
           highestRateAxes(rows)},
          2};
}

io::Figure soakFigure(const SoakResult& result) {
  io::Axes axes;
  axes.x_label = "samples served [millions]";
  axes.y_label = "resident memory of the node [MiB]";
  io::Curve curve{"", {}, {}, "-", kNode};
  const double per_piece = 1e-6 * static_cast<double>(result.sent) / static_cast<double>(result.memory.size());
  for (std::size_t i = 0; i < result.memory.size(); ++i) {
    curve.x.push_back(per_piece * static_cast<double>(i + 1));
    curve.y.push_back(static_cast<double>(result.memory[i]) / (1024.0 * 1024.0));
  }
  axes.curves.push_back(std::move(curve));
  return {fmt::format("Memory over samples, {} components", result.components), {axes}, 1};
}

}  // namespace rubber_suspension::benchmark
