// Plays the logs of several components side by side through a running node, once or repeatedly, and records the forces.
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ros_interface/log_player.h"
#include "ros_interface/play_recorder.h"

namespace rubber_suspension::ros_interface {

struct BenchTrack {
  std::string component;
  log::Log log;
  RecordPaths paths;
  std::optional<log::PoseLog> poses{};  ///< poses for six directions, played instead of displacements
  std::string wrenches{};               ///< CSV file for the wrenches of the last pass; empty: none
};

struct BenchCount {
  std::string component;
  std::size_t of = 0;          ///< number of samples that were to be played
  std::size_t samples = 0;     ///< number of samples that were sent
  std::size_t answered = 0;    ///< number of samples with at least one force
  std::size_t repeated = 0;    ///< number of further forces for samples that already had one
  std::size_t unexpected = 0;  ///< number of forces with unexpected stamps
  std::size_t gaps = 0;        ///< number of messages of the live gap
  double duration = 0.0;       ///< time of all passes, without pauses between them [s]
  bool complete = true;        ///< true if every sample of the last pass has an answer

  bool exactlyOneEach() const { return answered == samples && repeated == 0 && unexpected == 0; }
};

class BenchPlayer {
 public:
  /// Opens the files of the records. All of `options` except the name apply to every component. Throws LogError.
  BenchPlayer(const ros::NodeHandle& handle, const PlayOptions& options, std::vector<BenchTrack> tracks);

  /// Waits for the node. Throws PlayError.
  void connect();

  /// Plays the logs `passes` times, or until ROS is shut down if `passes` is 0. A pass is recorded up to the point
  /// where the playback ends. If a player or recorder throws, nothing is recorded and the exception is passed on.
  std::vector<BenchCount> play(std::size_t passes);

  /// Returns the forces of a component in its last pass [N], one for every sample of its log, 0 without an answer.
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
  std::vector<LogPlayer::Steady::time_point> starts_;  // when the next pass of each component starts
};

}  // namespace rubber_suspension::ros_interface
