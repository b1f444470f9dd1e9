// Plays the logs of several components side by side through a running node, once or over and over, and records them.
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ros_interface/log_player.h"
#include "ros_interface/play_recorder.h"

namespace rubber_suspension::ros_interface {

/// The log that one component has to play, and where its forces go.
struct BenchTrack {
  std::string component;
  log::Log log;
  RecordPaths paths;
  std::optional<log::PoseLog> poses{};  ///< of six directions, played in place of displacements; the log has its stamps
  std::string wrenches{};               ///< CSV file for the wrenches of the last pass; empty: not wanted
};

/// Sums over all passes of one component.
struct BenchCount {
  std::string component;
  std::size_t of = 0;          ///< samples of the logs that were to be played
  std::size_t samples = 0;     ///< sent
  std::size_t answered = 0;    ///< with at least one force
  std::size_t repeated = 0;    ///< forces too many for a sample
  std::size_t unexpected = 0;  ///< forces with unexpected stamps
  std::size_t gaps = 0;        ///< messages of the live gap
  double duration = 0.0;       ///< [s], without the pauses between passes
  bool complete = true;        ///< every pass was played to its end

  bool exactlyOneEach() const { return answered == samples && repeated == 0 && unexpected == 0; }
};

class BenchPlayer {
 public:
  /// `options` serve every component, but for its name. Opens the files; throws LogError.
  BenchPlayer(const ros::NodeHandle& handle, const PlayOptions& options, std::vector<BenchTrack> tracks);

  /// Wait for the node. Throws PlayError.
  void connect();

  /// Play `passes` times, 0: until ROS is shut down. What was played is recorded however it ends. Throws what a player
  /// or recorder throws.
  std::vector<BenchCount> play(std::size_t passes);

  /// The forces of a component in its last pass, of every sample of its log, answered or not [N].
  const std::vector<double>& lastForces(std::size_t track) const { return last_forces_[track]; }

 private:
  void playPass(std::size_t pass, bool more_follow);
  void playTrack(std::size_t track, std::size_t pass, bool more_follow);

  PlayOptions options_;
  std::vector<BenchTrack> tracks_;
  std::vector<std::unique_ptr<LogPlayer>> players_;
  std::vector<std::unique_ptr<PlayRecorder>> recorders_;
  std::vector<BenchCount> counts_;
  std::vector<std::vector<double>> last_forces_;
  std::int64_t period_ = 0;
  std::vector<LogPlayer::Steady::time_point> starts_;  // of each component's next pass
};

}  // namespace rubber_suspension::ros_interface
