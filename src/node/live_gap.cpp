// Computes the live gap.
#include "node/live_gap.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "log/even_blocks.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/prepared_log.h"
#include "rubber_suspension/measurement/rig_model.h"

namespace rubber_suspension::node {
namespace {

constexpr std::size_t kFewest = 100;         // samples
constexpr Eigen::Index kWarpedWhole = 2000;  // samples; a rating then takes 10 ms per second at 10 kHz
constexpr std::size_t kHistory = 600;        // largest number of reports in the trend

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

// Returns the force due to those errors of the rig that are within its tolerances. Larger errors count as gap. The fit
// assumes white noise, because with slow noise an offset would be poorly determined and could enlarge the gap.
Eigen::VectorXd tolerated(const measurement::RigModel& rig, const measurement::RigColumns& columns) {
  const measurement::RigFit fit = rig.fit(0, columns, 0);
  Eigen::VectorXd part = Eigen::VectorXd::Zero(fit.residual.size());
  for (Eigen::Index i = 0; i < fit.values.size(); ++i) {
    if (std::abs(fit.values[i]) <= io::kTolerated * fit.rig.priors[i]) {
      part += fit.values[i] * fit.rig.columns.col(i);
    }
  }
  return part;
}

// Resamples the measured and the simulated force, which have the same stamps, to uniform steps and compares them.
void measure(const std::vector<MatchedSample>& samples, SimulatedForce force, io::RigTolerances tolerances,
             LiveGap& gap) {
  tolerances.initial_state.value = 0.0;  // the component has processed all samples before the window
  const measurement::PreparedLog measured = measurement::preparePiece(logOf(samples, &MatchedSample::measured));
  const gap::PreparedRecord record(measured.record);
  const Eigen::VectorXd simulated = log::evenRecord(logOf(samples, force)).force;
  const measurement::RigModel rig({record}, {measurement::maskOf(record)}, tolerances);
  const measurement::RigColumns columns = rig.columns({simulated}, {}).front();
  const Eigen::VectorXd error = record.withoutRig(record.force - simulated);
  const Eigen::VectorXd residual = record.withoutRig(record.force - simulated - tolerated(rig, columns));
  gap.rig_findings = measured.findings;
  for (const measurement::RigFinding& finding : rig.findings(0, rig.fit(0, columns))) {
    gap.rig_findings.push_back(finding);
  }
  gap.iso18571 = gap::rateIso18571(record.force, simulated, kWarpedWhole);
  const double scale = std::sqrt(record.counted()) * record.force_deviation;
  gap.gap = residual.norm() / scale;
  gap.gap_as_recorded = error.norm() / scale;
  // Slow noise does not count, because it could not be distinguished from errors of the model.
  gap.noise_floor = std::min(gap::whiteNoiseFloor(record, residual), gap.gap);
  gap.beyond_noise = gap::residualAboveFloor(gap.gap, gap.noise_floor);
  gap.cells = gap::gapMap({record}, {residual}, {gap.noise_floor});
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

LiveGap measureGap(const std::vector<MatchedSample>& window, const GapSettings& settings,
                   const io::RigTolerances& tolerances, SimulatedForce force) {
  std::vector<MatchedSample> samples;
  std::copy_if(window.begin(), window.end(), std::back_inserter(samples),
               [&](const MatchedSample& sample) { return !std::isnan(sample.*force); });
  // Samples before the last time gap are omitted, because a spectrum needs a record without time gaps.
  samples.erase(samples.begin(),
                samples.begin() + static_cast<std::ptrdiff_t>(log::stretchesOf(logOf(samples, force)).back()));
  LiveGap gap;
  gap.samples = samples.size();
  if (samples.empty()) {
    gap.reason = "no measured force has the same stamp as a sample";
    return gap;
  }
  gap.stamp = samples.back().stamp;
  gap.window = 1e-9 * static_cast<double>(samples.back().stamp - samples.front().stamp);
  // In a window that has just begun, the initial transient would appear as a gap.
  if (samples.size() < kFewest || gap.window < 0.1 * settings.window) {
    gap.reason = "the window does not contain enough samples yet";
    return gap;
  }
  try {
    measure(samples, force, tolerances, gap);
    gap.known = true;
  } catch (const log::LogError& error) {
    gap.reason = error.what();
  }
  return gap;
}

LiveGap GapTracker::update(const std::vector<MatchedSample>& window, SimulatedForce force) {
  LiveGap gap = measureGap(window, settings_, tolerances_, force);
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

// Returns the slope of a line fitted to the history, or 0 while all windows overlap, because they do not show a trend.
double GapTracker::trend() const {
  if (history_.size() < 3 || history_.back().time - history_.front().time < settings_.window) {
    return 0.0;
  }
  Eigen::ArrayXd time(history_.size());
  Eigen::ArrayXd gap(history_.size());
  for (std::size_t i = 0; i < history_.size(); ++i) {
    time[static_cast<Eigen::Index>(i)] = history_[i].time;
    gap[static_cast<Eigen::Index>(i)] = history_[i].gap;
  }
  time -= time.mean();
  return (time * gap).sum() / time.square().sum();
}

}  // namespace rubber_suspension::node
