// The live gap.
#include "node/live_gap.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::node {
namespace {

constexpr std::size_t kFewest = 100;   // samples; as few as the diagnosis takes
constexpr std::size_t kHistory = 600;  // reports that the trend is taken over, at most

log::Log logOf(const std::vector<MatchedSample>& samples, SimulatedForce force) {
  log::Log log;
  log.name = "live";
  for (const MatchedSample& sample : samples) {
    log.stamp.push_back(sample.stamp);
    log.displacement.push_back(sample.displacement);
    log.force.push_back(sample.*force);
  }
  return log;
}

// Both forces on one even time base: the records are of the same stamps.
void measure(const std::vector<MatchedSample>& samples, SimulatedForce force, LiveGap& gap) {
  const log::Record measured = log::makeRecord(logOf(samples, &MatchedSample::measured));
  const log::Record simulated = log::makeRecord(logOf(samples, force));
  const Eigen::VectorXd residual = measured.force - simulated.force;
  gap.gap = gap::gapOfResidual(residual, measured.force_deviation);
  gap.noise_floor = std::min(gap::whiteNoiseFloor(measured, residual), gap.gap);
  gap.beyond_noise = gap::residualAboveFloor(gap.gap, gap.noise_floor);
  gap.cells = gap::gapMap({measured}, {residual}, {gap.noise_floor});
  for (const gap::GapCell& cell : gap.cells) {
    gap.share[static_cast<std::size_t>(cell.quantity)] += cell.share;
  }
}

}  // namespace

GapLevel LiveGap::level(const GapSettings& settings) const {
  if (!known) {
    return GapLevel::unknown;
  }
  return beyond_noise >= settings.error  ? GapLevel::error
         : beyond_noise >= settings.warn ? GapLevel::warn
                                         : GapLevel::ok;
}

LiveGap measureGap(const std::vector<MatchedSample>& window, const GapSettings& settings, SimulatedForce force) {
  std::vector<MatchedSample> samples;
  std::copy_if(window.begin(), window.end(), std::back_inserter(samples),
               [&](const MatchedSample& sample) { return !std::isnan(sample.*force); });
  LiveGap gap;
  gap.samples = samples.size();
  if (samples.empty()) {
    gap.reason = "no measured force has the stamp of a sample";
    return gap;
  }
  gap.stamp = samples.back().stamp;
  gap.window = 1e-9 * static_cast<double>(samples.back().stamp - samples.front().stamp);
  // A window that has just begun would take its first transient for a gap, a thinned one is as good as a full one.
  if (samples.size() < kFewest || gap.window < 0.1 * settings.window) {
    gap.reason = "the window is not filled yet";
    return gap;
  }
  try {
    measure(samples, force, gap);
    gap.known = true;
  } catch (const log::LogError& error) {
    gap.reason = error.what();
  }
  return gap;
}

LiveGap GapTracker::update(const GapMonitor& monitor, SimulatedForce force) {
  LiveGap gap = measureGap(monitor.window(settings_.window), settings_, force);
  if (!gap.known) {
    return gap;
  }
  const double now = 1e-9 * static_cast<double>(gap.stamp);
  if (!history_.empty() && now < history_.back().time) {
    history_.clear();  // a new replay
  }
  if (history_.empty() || now > history_.back().time) {
    history_.push_back({now, gap.gap});
  }
  if (history_.size() > kHistory) {
    history_.pop_front();
  }
  gap.trend = trend();
  return gap;
}

// Slope of the straight line through the history; windows that overlap say nothing of a trend.
double GapTracker::trend() const {
  if (history_.size() < 3 || history_.back().time - history_.front().time < settings_.window) {
    return 0.0;
  }
  const double count = static_cast<double>(history_.size());
  double mean_time = 0.0;
  double mean_gap = 0.0;
  for (const Point& point : history_) {
    mean_time += point.time / count;
    mean_gap += point.gap / count;
  }
  double cross = 0.0;
  double square = 0.0;
  for (const Point& point : history_) {
    cross += (point.time - mean_time) * (point.gap - mean_gap);
    square += (point.time - mean_time) * (point.time - mean_time);
  }
  return cross / square;
}

}  // namespace rubber_suspension::node
