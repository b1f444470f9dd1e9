// Simulates a component on a recorded log, offline, and shows the result.
#include "rubber_suspension/gap/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "io/progress.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::gap {
namespace {

constexpr std::size_t kLargestCurve = 50000;  // points; more than anyone can see

// Every n-th value times a factor, n such that the curve is no longer than it may be.
std::vector<double> thinned(const std::vector<double>& values, double factor) {
  const std::size_t stride = 1 + values.size() / kLargestCurve;
  std::vector<double> result;
  for (std::size_t i = 0; i < values.size(); i += stride) {
    result.push_back(values[i] * factor);
  }
  return result;
}

std::vector<double> secondsOf(const log::Log& log) {
  std::vector<double> seconds(log.size());
  for (std::size_t i = 0; i < log.size(); ++i) {
    seconds[i] = static_cast<double>(log.stamp[i] - log.stamp[0]) * 1e-9;
  }
  return seconds;
}

io::Axes forceAxes(const std::string& x_label, const std::vector<double>& x, const log::Log& log,
                   const std::vector<double>& force, const ForceLabels& labels) {
  io::Axes axes;
  axes.x_label = x_label;
  axes.y_label = "force [kN]";
  if (!log.force.empty()) {
    axes.curves.push_back({labels.log, x, thinned(log.force, 1e-3), "-", 0});
  }
  axes.curves.push_back({labels.force, x, thinned(force, 1e-3), "-", 1});
  return axes;
}

io::Axes gapAxes(const std::vector<double>& seconds, const log::Log& log, const std::vector<double>& force,
                 const ForceLabels& labels) {
  std::vector<double> gap(log.size());
  std::transform(log.force.begin(), log.force.end(), force.begin(), gap.begin(), std::minus<>());
  io::Axes axes;
  axes.x_label = "time [s]";
  axes.y_label = labels.log + " - " + labels.force + " [kN]";
  axes.curves.push_back({"", seconds, thinned(gap, 1e-3), "-", 4});
  return axes;
}

// The force for a short time around its largest value, where single cycles can be told apart.
io::Axes closeUpAxes(const log::Log& log, const std::vector<double>& force) {
  constexpr std::int64_t kHalfWidth = 1000000000;  // [ns]
  const auto largest =
      std::max_element(force.begin(), force.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  const std::int64_t middle = log.stamp[static_cast<std::size_t>(largest - force.begin())];
  std::vector<double> seconds;
  std::vector<double> close_up;
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (std::abs(log.stamp[i] - middle) <= kHalfWidth) {
      seconds.push_back(static_cast<double>(log.stamp[i] - log.stamp[0]) * 1e-9);
      close_up.push_back(force[i]);
    }
  }
  io::Axes axes;
  axes.title = "around the largest force";
  axes.x_label = "time [s]";
  axes.y_label = "force [kN]";
  axes.curves.push_back({"", thinned(seconds, 1.0), thinned(close_up, 1e-3), "-", 1});
  return axes;
}

}  // namespace

std::vector<double> simulateLog(const component::Component& component, const log::Log& log,
                                component::StreamCounters* counters) {
  log::checkLengths(log);
  component::SampleStream stream(component);
  io::Progress progress("simulating " + log.name, log.size());
  std::vector<double> force;
  force.reserve(log.size());
  constexpr std::size_t kPortion = 4096;  // samples that are checked and simulated while they are near the processor
  for (std::size_t first = 0; first < log.size(); first += kPortion) {
    const std::size_t size = std::min(kPortion, log.size() - first);
    log::checkSamples(log, first, size);
    force.resize(first + size);
    const std::size_t accepted =
        stream.pushAll(log.stamp.data() + first, log.displacement.data() + first, size, force.data() + first);
    // All samples are checked, so every sample is accepted but one whose force is too large for a double.
    if (accepted < size) {
      throw log::LogError(fmt::format("{}: sample {}: displacement {:g} m gives a force that is not finite", log.name,
                                      first + accepted + 1, log.displacement[first + accepted]));
    }
    progress.advance(size);
  }
  if (counters != nullptr) {
    *counters = stream.counters();
  }
  return force;
}

Replay replay(const component::Component& component, const log::Log& log) {
  component::StreamCounters counters;
  std::vector<double> force = simulateLog(component, log, &counters);
  return {std::move(force), counters.bridged};
}

std::string summary(const std::string& component, const log::Log& log, const Replay& replay) {
  const auto range = std::minmax_element(replay.force.begin(), replay.force.end());
  const double duration = static_cast<double>(log.stamp.back() - log.stamp.front()) * 1e-9;
  std::string text = fmt::format("{}: {} samples, {:.6g} s, force {:.6g} to {:.6g} N", component, log.size(), duration,
                                 *range.first, *range.second);
  const bool varies = !log.force.empty() && *std::min_element(log.force.begin(), log.force.end()) <
                                                *std::max_element(log.force.begin(), log.force.end());
  if (varies) {
    text += fmt::format(", gap to the measured force {:.4f}", relativeGap(log.force, replay.force));
  }
  return text;
}

io::Figure replayFigure(const std::string& component, const log::Log& log, const std::vector<double>& force,
                        const ForceLabels& labels) {
  const std::vector<double> seconds = thinned(secondsOf(log), 1.0);
  const std::vector<double> millimetres = thinned(log.displacement, 1e3);
  io::Axes displacement;
  displacement.x_label = "time [s]";
  displacement.y_label = "displacement [mm]";
  displacement.curves.push_back({"", seconds, millimetres, "-", 7});
  io::Figure figure;
  figure.title = fmt::format("{}, {}", component, log.name);
  figure.axes = {displacement, forceAxes("displacement [mm]", millimetres, log, force, labels),
                 forceAxes("time [s]", seconds, log, force, labels)};
  figure.axes.push_back(log.force.empty() ? closeUpAxes(log, force) : gapAxes(seconds, log, force, labels));
  return figure;
}

}  // namespace rubber_suspension::gap
