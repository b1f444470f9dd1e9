// Simulates a component on a recorded log and draws the result.
#include "rubber_suspension/gap/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "gap/last_cycles.h"
#include "io/progress.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::gap {
namespace {

constexpr std::size_t kMostPoints = 4000;  // largest number of points of a curve; more cannot be distinguished
constexpr double kCycles = 5.0;            // number of cycles in a figure; more would merge into one area
constexpr double kBroad = 2.8;             // line width of the lower of two curves [pt]
constexpr double kThin = 1.0;

struct Stretch {
  std::size_t first;
  std::size_t last;
};

// Returns every n-th value of a stretch times a factor, so that there are at most kMostPoints.
std::vector<double> thinned(const std::vector<double>& values, const Stretch& stretch, double factor) {
  const std::size_t stride = 1 + (stretch.last - stretch.first) / kMostPoints;
  std::vector<double> result;
  for (std::size_t i = stretch.first; i < stretch.last; i += stride) {
    result.push_back(values[i] * factor);
  }
  return result;
}

std::vector<double> secondsOf(const log::Log& log) {
  std::vector<double> seconds(log.size());
  for (std::size_t i = 0; i < log.size(); ++i) {
    seconds[i] = log.duration(0, i);
  }
  return seconds;
}

// Draws the simulated curve thin and above the broad measured curve, so that both are visible.
io::Axes forceAxes(const std::string& x_label, const std::vector<double>& x, const log::Log& log,
                   const std::vector<double>& force, const Stretch& stretch, const ForceLabels& labels) {
  io::Axes axes{"", x_label, labels.quantity};
  if (!log.force.empty()) {
    axes.curves.push_back({labels.log, x, thinned(log.force, stretch, labels.factor), "-", 0, kBroad});
  }
  axes.curves.push_back(
      {labels.force, x, thinned(force, stretch, labels.factor), "-", log.force.empty() ? 1 : io::kInk, kThin});
  return axes;
}

io::Axes residualAxes(const std::vector<double>& seconds, const log::Log& log, const std::vector<double>& force,
                      const Stretch& stretch, const ForceLabels& labels) {
  std::vector<double> residual(log.size());
  std::transform(log.force.begin(), log.force.end(), force.begin(), residual.begin(), std::minus<>());
  io::Axes axes{"", "time [s]", labels.log + " - " + labels.force + " [kN]"};
  axes.curves.push_back({"", thinned(seconds, stretch, 1.0), thinned(residual, stretch, 1e-3), "-", 4});
  return axes;
}

// Returns the envelope of the whole log: the smallest and the largest value in each of some stretches. The value is the
// measured minus the simulated force, or the simulated force if no force was measured.
io::Axes envelopeAxes(const std::vector<double>& seconds, const log::Log& log, const std::vector<double>& force,
                      const ForceLabels& labels) {
  constexpr std::size_t kStretches = 300;
  const std::size_t count = std::min(kStretches, log.size());
  io::Curve low{"", {}, {}, "-", 4, kThin};
  io::Curve high = low;
  for (std::size_t s = 0; s < count; ++s) {
    double smallest = std::numeric_limits<double>::infinity();
    double largest = -smallest;
    for (std::size_t i = log.size() * s / count; i < log.size() * (s + 1) / count; ++i) {
      const double value = (log.force.empty() ? force[i] : log.force[i] - force[i]) * 1e-3;
      smallest = std::min(smallest, value);
      largest = std::max(largest, value);
    }
    for (io::Curve* curve : {&low, &high}) {
      curve->x.push_back(seconds[log.size() * s / count]);
    }
    low.y.push_back(smallest);
    high.y.push_back(largest);
  }
  io::Axes axes{"whole log: smallest and largest values", "time [s]",
                log.force.empty() ? "force [kN]" : labels.log + " - " + labels.force + " [kN]"};
  axes.curves = {low, high};
  return axes;
}

[[noreturn]] void refuseSample(const component::Component& component, const log::Log& log, std::size_t sample) {
  checkTemperature(component, log);
  throw log::LogError(fmt::format("{}: sample {}: displacement {:g} m gives a force that is not finite", log.name,
                                  sample + 1, log.displacement[sample]));
}

// Returns the mean of the measured minus the simulated force over the samples that count [N].
double meanDifference(const log::Log& log, const std::vector<double>& force) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < force.size(); ++i) {
    const bool counts = log.counts.empty() || log.counts[i] > 0.0;
    sum += counts ? log.force[i] - force[i] : 0.0;
    count += counts ? 1.0 : 0.0;
  }
  return sum / count;
}

}  // namespace

void checkTemperature(const component::Component& component, const log::Log& log, std::size_t first) {
  if (!component.shiftsWithTemperature()) {
    return;
  }
  const element::Range range = component.temperatures();
  const auto bad = std::find_if(log.temperature.begin(), log.temperature.end(),
                                [&](double temperature) { return !range.contains(temperature); });
  if (bad != log.temperature.end()) {
    throw log::LogError(fmt::format(
        "{}: sample {}: temperature {:g} degC is out of range; accepted: {} degC, the range of the component's shift",
        log.name, first + static_cast<std::size_t>(bad - log.temperature.begin()) + 1, *bad, element::describe(range)));
  }
}

std::vector<double> simulateLog(const component::Component& component, const log::Log& log,
                                component::StreamCounters* counters) {
  log::checkLengths(log);
  component::SampleStream stream(component);
  io::Progress progress("simulating " + log.name, log.size());
  std::vector<double> force;
  force.reserve(log.size());
  constexpr std::size_t kPortion = 4096;  // number of samples that fit into the cache
  for (std::size_t first = 0; first < log.size(); first += kPortion) {
    const std::size_t size = std::min(kPortion, log.size() - first);
    log::checkSamples(log, first, size);
    force.resize(first + size);
    const double* const temperature = log.temperature.empty() ? nullptr : log.temperature.data() + first;
    const std::size_t accepted = stream.pushAll(log.stamp.data() + first, log.displacement.data() + first, temperature,
                                                size, force.data() + first);
    // All samples were checked before. A sample is refused here only if its force is too large for a double, or if its
    // temperature is outside the range of the component's shift.
    if (accepted < size) {
      refuseSample(component, log, first + accepted);
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

std::string summary(const std::string& component, const log::Log& log, const Replay& replay, Offset offset) {
  const auto range = std::minmax_element(replay.force.begin(), replay.force.end());
  const double duration = log.duration(0, log.size() - 1);
  std::string text = fmt::format("{}: {} samples, {:.6g} s, force {:.6g} to {:.6g} N", component, log.size(), duration,
                                 *range.first, *range.second);
  const bool varies = !log.force.empty() && *std::min_element(log.force.begin(), log.force.end()) <
                                                *std::max_element(log.force.begin(), log.force.end());
  if (!varies) {
    return text;
  }
  if (offset == Offset::kept) {
    return text + fmt::format(", gap to the measured force {:.4f}", relativeGap(log.force, replay.force, log.counts));
  }
  const double mean = meanDifference(log, replay.force);
  std::vector<double> force = replay.force;
  for (double& one : force) {
    one += mean;
  }
  return text + fmt::format(", gap to the measured force {:.4f} without an offset of {:.4g} N",
                            relativeGap(log.force, force, log.counts), mean);
}

io::Figure replayFigure(const std::string& component, const log::Log& log, const std::vector<double>& force,
                        const ForceLabels& labels) {
  const double frequency = meanFrequency(log);
  const Stretch stretch{firstOfLastCycles(log, frequency, kCycles), log.size()};
  const std::vector<double> seconds = secondsOf(log);
  const std::vector<double> shown = thinned(seconds, stretch, 1.0);
  const std::vector<double> millimetres = thinned(log.displacement, stretch, 1e3);
  io::Figure figure{fmt::format("{}, {}", component, log.name)};
  if (stretch.first > 0) {
    figure.title +=
        fmt::format(": the last {:.3g} s of {:.5g} s", seconds.back() - seconds[stretch.first], seconds.back());
  }
  figure.axes = {forceAxes("displacement [mm]", millimetres, log, force, stretch, labels),
                 forceAxes("time [s]", shown, log, force, stretch, labels), envelopeAxes(seconds, log, force, labels)};
  if (log.force.empty()) {
    io::Axes displacement;
    displacement.x_label = "time [s]";
    displacement.y_label = "displacement [mm]";
    displacement.curves.push_back({"", shown, millimetres, "-", 7});
    figure.axes.push_back(displacement);
  } else {
    figure.axes.push_back(residualAxes(seconds, log, force, stretch, labels));
  }
  return figure;
}

io::Figure replayFigure(const std::string& component, const log::PoseLog& log,
                        const std::array<std::vector<double>, 6>& wrench) {
  constexpr double kDegrees = 180.0 / element::kPi;
  constexpr std::array<const char*, 6> kForces = {"Fx [kN]", "Fy [kN]", "Fz [kN]", "Mx [N m]", "My [N m]", "Mz [N m]"};
  constexpr std::array<const char*, 6> kPlaces = {"x [mm]", "y [mm]", "z [mm]", "rx [deg]", "ry [deg]", "rz [deg]"};
  const auto changes = [](const std::vector<double>& values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return *least < *most;
  };
  io::Figure figure;
  figure.title = fmt::format("{}, {}", component, log.name);
  for (std::size_t k = 0; k < wrench.size(); ++k) {
    log::Log direction;
    direction.stamp = log.stamp;
    direction.displacement = log.coordinate[k];
    direction.force = log.wrench[k];
    if (!changes(direction.displacement) && !changes(wrench[k])) {
      continue;
    }
    const bool turns = k >= 3;
    const ForceLabels labels{"measured", "simulated", kForces[k], turns ? 1.0 : 1e-3};
    const Stretch stretch{firstOfLastCycles(direction, meanFrequency(direction), kCycles), log.size()};
    figure.axes.push_back(forceAxes(kPlaces[k], thinned(direction.displacement, stretch, turns ? kDegrees : 1e3),
                                    direction, wrench[k], stretch, labels));
    figure.axes.push_back(
        forceAxes("time [s]", thinned(secondsOf(direction), stretch, 1.0), direction, wrench[k], stretch, labels));
  }
  return figure;
}

}  // namespace rubber_suspension::gap
