// Plays the logs of several components side by side through a running node.
#include "ros_interface/bench_player.h"

#include <ros/init.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <utility>

namespace rubber_suspension::ros_interface {

namespace {

// Returns the time from one pass of a looped playback to the next [ns], which is the duration of the longest log plus
// one of its sampling intervals. All components use this time, so that they remain synchronous.
std::int64_t loopPeriod(const std::vector<BenchTrack>& tracks) {
  std::int64_t longest = 0;
  for (const BenchTrack& track : tracks) {
    const std::int64_t duration = track.log.stamp.back() - track.log.stamp.front();
    longest = std::max(longest, duration + duration / static_cast<std::int64_t>(track.log.size() - 1));
  }
  return longest;
}

}  // namespace

BenchPlayer::BenchPlayer(const ros::NodeHandle& handle, const PlayOptions& options, std::vector<BenchTrack> tracks)
    : options_(options), tracks_(std::move(tracks)) {
  for (const BenchTrack& track : tracks_) {
    log::checkLog(track.log);
    options_.component = track.component;
    options_.show_progress = players_.empty();
    options_.record_gap = !track.paths.gaps.empty() || !track.paths.bag.empty();
    players_.push_back(std::make_unique<LogPlayer>(handle, options_));
    recorders_.push_back(std::make_unique<PlayRecorder>(track.paths, track.component));
    counts_.emplace_back();
    counts_.back().component = track.component;
  }
  last_forces_.resize(tracks_.size());
  period_ = loopPeriod(tracks_);
}

void BenchPlayer::connect() {
  for (auto& player : players_) {
    player->connect();
  }
}

void BenchPlayer::playTrack(std::size_t track, std::size_t pass, bool more_follow) {
  log::Log log = tracks_[track].log;
  for (std::int64_t& stamp : log.stamp) {
    stamp += static_cast<std::int64_t>(pass) * period_;  // time continues, and the component keeps its state
  }
  std::optional<log::PoseLog>& poses = tracks_[track].poses;
  const PlayResult result = players_[track]->play(log, starts_[track], more_follow, poses ? &*poses : nullptr);
  if (options_.rate > 0.0) {
    const std::chrono::duration<double> period(1e-9 * static_cast<double>(period_) / options_.rate);
    starts_[track] = players_[track]->start() + std::chrono::duration_cast<LogPlayer::Steady::duration>(period);
  }
  recorders_[track]->add(log, result);
  if (poses && !tracks_[track].wrenches.empty() && result.answered() == log.size()) {
    poses->stamp = log.stamp;
    log::writeWrenchCsv(tracks_[track].wrenches, *poses, result.wrench);
  }
  last_forces_[track] = result.totals();
  BenchCount& count = counts_[track];
  count.of += log.size();
  // No answer can come after ROS is shut down. Then samples without an answer do not count as sent.
  count.samples += ros::ok() ? result.sent : result.answered();
  count.answered += result.answered();
  for (const std::uint32_t answers : result.answers) {
    count.repeated += answers > 1 ? answers - 1 : 0;
  }
  count.unexpected += result.unexpected;
  count.gaps += result.gaps.size();
  count.duration += result.duration;
  count.complete = result.answered() == log.size();
}

// Plays all logs once, in a thread per component, since each player has a callback queue of its own.
void BenchPlayer::playPass(std::size_t pass, bool more_follow) {
  std::vector<std::future<void>> others;
  for (std::size_t track = 1; track < tracks_.size(); ++track) {
    others.push_back(
        std::async(std::launch::async, [this, track, pass, more_follow] { playTrack(track, pass, more_follow); }));
  }
  playTrack(0, pass, more_follow);
  for (auto& other : others) {
    other.get();
  }
}

std::vector<BenchCount> BenchPlayer::play(std::size_t passes) {
  connect();
  starts_.assign(tracks_.size(), LogPlayer::Steady::now());
  const auto is_complete = [](const BenchCount& count) { return count.complete; };
  for (std::size_t pass = 0; (passes == 0 || pass < passes) && ros::ok(); ++pass) {
    playPass(pass, passes == 0 || pass + 1 < passes);
    if (!std::all_of(counts_.begin(), counts_.end(), is_complete)) {
      break;
    }
  }
  for (auto& recorder : recorders_) {
    recorder->close();
  }
  return counts_;
}

}  // namespace rubber_suspension::ros_interface
