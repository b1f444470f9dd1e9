// Recorder of a playback.
#include "ros_interface/play_recorder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <rubber_suspension/Gap.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "bag/bag_writer.h"
#include "log/samples.h"

namespace rubber_suspension::ros_interface {
namespace {

constexpr const char* kGapHeader =
    "time_s,level,window_s,samples,gap,noise_floor,beyond_noise,trend_per_s,share_stiffness,share_loss,"
    "share_harmonics,share_mean,share_drift,iso18571_total,iso18571_corridor,iso18571_phase,iso18571_magnitude,"
    "iso18571_slope,iso18571_repeats";

std::string gapRow(std::int64_t stamp, const Gap& gap) {
  const std::array<double, 14> numbers = {gap.gap,
                                          gap.noise_floor,
                                          gap.beyond_noise,
                                          gap.trend,
                                          gap.share_stiffness,
                                          gap.share_loss,
                                          gap.share_harmonics,
                                          gap.share_mean,
                                          gap.share_drift,
                                          gap.iso18571_total,
                                          gap.iso18571_corridor,
                                          gap.iso18571_phase,
                                          gap.iso18571_magnitude,
                                          gap.iso18571_slope};
  return fmt::format("{:.9f},{},{:.9g},{},{:.9g},{}", 1e-9 * static_cast<double>(stamp), static_cast<int>(gap.level),
                     gap.window, gap.samples, fmt::join(numbers, ","), static_cast<int>(gap.iso18571_repeats));
}

}  // namespace

RecordPaths recordPathsIn(const std::string& folder, const std::string& component) {
  std::string name = component.substr(std::min(component.find_first_not_of('/'), component.size()));
  std::replace(name.begin(), name.end(), '/', '_');
  const std::string base = (std::filesystem::path(folder) / name).string();
  return {base + "_force.csv", base + "_gap.csv", base + ".bag"};
}

PlayRecorder::PlayRecorder(const RecordPaths& paths, const std::string& component) {
  if (!paths.forces.empty()) {
    forces_ = std::make_unique<log::LogCsvWriter>(paths.forces, true);
  }
  if (!paths.gaps.empty()) {
    gaps_ = std::make_unique<log::NewFile>(paths.gaps);
    gaps_->line(kGapHeader);
  }
  if (!paths.bag.empty()) {
    bag_ = std::make_unique<bag::BagWriter>(paths.bag, component);
  }
}

PlayRecorder::~PlayRecorder() = default;

void PlayRecorder::add(const log::Log& log, const PlayResult& result) {
  for (std::size_t i = 0; forces_ && i < log.size(); ++i) {
    if (result.answers[i] > 0) {
      forces_->append(log.stamp[i], log.displacement[i], result.force[i].total);
    }
  }
  for (std::size_t i = 0; gaps_ && i < result.gaps.size(); ++i) {
    gaps_->line(gapRow(result.gap_stamps[i], *result.gaps[i]));
  }
  if (bag_) {
    addToBag(log, result);
  }
}

void PlayRecorder::addToBag(const log::Log& log, const PlayResult& result) {
  const std::int64_t shift = result.shift;
  for (std::size_t i = 0; i < result.sent; ++i) {
    bag_->writeDisplacement(log.stamp[i] + shift, log.displacement[i]);
    if (!log.force.empty() && log::isCounted(log, i)) {
      bag_->writeMeasuredForce(log.stamp[i] + shift, log.force[i]);
    }
    if (result.answers[i] > 0) {
      bag_->writeForce(log.stamp[i] + shift, log.displacement[i], result.force[i]);
    }
  }
  for (const GapConstPtr& gap : result.gaps) {
    bag_->writeGap(*gap);
  }
}

void PlayRecorder::close() {
  if (forces_) {
    forces_->close();
  }
  if (gaps_) {
    gaps_->commit();
  }
  if (bag_) {
    bag_->close();
  }
}

}  // namespace rubber_suspension::ros_interface
